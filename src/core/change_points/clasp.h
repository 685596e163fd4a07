#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/change_points/change_point.h"

/// \file
/// Change points of a whole series.

namespace contact_shapelets::core {

/// Parameters of FindChangePoints(). Defaults are those that the authors of ClaSP published, but for max_samples.
struct ClaspOptions {
  int window = 0;               ///< [samples] of the series that are compared, at least 3; 0 for SelectWindowSize()
  int neighbours = 3;           ///< that vote, 1 to 15
  double significance = 1e-15;  ///< largest p-value of a change point, in (0, 1)
  int shortest_segment = 5;     ///< [windows], at least 2
  /// Longer series are averaged in blocks of equally many samples, so that at most as many blocks are compared: time
  /// grows with their square. Change points then are multiples of the block's length. At least 100.
  int max_samples = 20000;

  /// Every parameter that is out of range, one line each with its name and range; an empty string if all values are
  /// valid.
  std::string Faults() const;
};

/// What FindChangePoints() found.
struct ChangePoints {
  std::vector<ChangePoint> points;  ///< in order
  int window = 0;                   ///< [samples] that was used, a multiple of `block`
  int block = 1;                    ///< [samples] that were averaged to one
};

/// Where the shape of a series changes, by ClaSP (Schäfer, Ermshaus, Leser: ClaSP - Time Series Segmentation, CIKM
/// 2021): the split with the best classification score, if it is significant, and then those of either part.
///
/// No change point is closer than `shortest_segment` windows to another one or to an end. So a series shorter than two
/// such segments has none. Values have any unit; shape is independent of offset and scale. Equal input gives equal
/// output. \throws std::invalid_argument for options out of range and for values that are not finite or beyond 1e100.
ChangePoints FindChangePoints(const Eigen::Ref<const Eigen::VectorXd>& series, const ClaspOptions& options = {});

}  // namespace contact_shapelets::core
