#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/change_points/change_point.h"
#include "core/change_points/sliding_neighbours.h"

/// \file
/// Change points of a stream.

namespace contact_shapelets::core {

/// Parameters of StreamingClasp.
struct StreamingClaspOptions {
  int window = 0;               ///< [samples] that are compared, at least 3; 0 for SelectWindowSize() of the warm-up
  int warm_up = 10000;          ///< [samples] that choose the window, at least 20
  int sliding_window = 10000;   ///< [samples] that a change is looked for in, at least 200
  int neighbours = 3;           ///< that vote, 1 to 15
  int stride = 25;              ///< [samples] from one look for a change to the next, at least 1
  double significance = 1e-50;  ///< largest p-value of a change point, in (0, 1)
  int shortest_segment = 5;     ///< [windows], at least 2

  /// Every parameter that is out of range, one line each with its name and range; an empty string if all values are
  /// valid.
  std::string Faults() const;
};

/// Finds change points of a stream as it comes, by ClaSS (Ermshaus, Schäfer, Leser: Raising the ClaSS of streaming time
/// series segmentation, VLDB 2023): ClaSP over the samples since the last change point, at most those of a sliding
/// window.
///
/// Samples are kept until the warm-up is over, and then worked off a few at a time, so that no call takes long. A
/// change point is found `shortest_segment` windows after the change at the soonest. Equal streams give equal change
/// points.
class StreamingClasp {
 public:
  /// \throws std::invalid_argument for options out of range.
  explicit StreamingClasp(const StreamingClaspOptions& options = {});

  /// Takes the next sample; returns the change points that were found, none most of the time. Throws
  /// std::invalid_argument if it is not finite or beyond 1e100, and stays as it was.
  std::vector<ChangePoint> Append(double sample);
  /// Works off what is kept, as at the end of a stream; returns the change points that were found.
  std::vector<ChangePoint> Flush();

  /// Samples that are compared; 0 until the warm-up is over.
  int window() const { return window_; }

 private:
  void Start();
  std::vector<ChangePoint> WorkOff(std::size_t samples);
  std::optional<ChangePoint> LookForChange();

  StreamingClaspOptions options_;
  int window_ = 0;
  std::int64_t appended_ = 0;
  std::int64_t worked_off_ = 0;
  std::deque<double> kept_;
  std::optional<SlidingNeighbours> neighbours_;
};

}  // namespace contact_shapelets::core
