#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// Random dilated shapelets (Guillaume, Vrain and Elloumi: Random Dilated Shapelet Transform, ICPRAI 2022), without
/// labels: subsequences of few samples with gaps between them, drawn from the training series. There are many and none
/// is learned. They vote on the clusters beside the learned shapelets, and are no part of a model.

namespace contact_shapelets::core {

/// Shapelets drawn at random from series.
class RandomShapelets {
 public:
  /// Samples of each shapelet; fewer where series are shorter than four times as many.
  static constexpr int kLength = 9;

  /// No shapelets.
  RandomShapelets() = default;

  /// Draws `count` (0 or more) shapelets from `series`, each of 2 or more finite values. The dilation of each is 2^u, u
  /// uniform from 0 to where the shapelet is as long as the median series. Equal seeds give equal shapelets.
  /// \throws std::invalid_argument where there is no series, or one of fewer than 2 values.
  RandomShapelets(const std::vector<Eigen::VectorXf>& series, int count, std::uint64_t seed);

  /// Samples [count()] from the first to behind the last that each shapelet spans.
  Eigen::VectorXf Reaches() const;

  /// Number of shapelets.
  int count() const { return static_cast<int>(shapelets_.size()); }

  /// Distances [N, count()] of `series` (each of 2 or more finite values) to the shapelets: sqrt(1 - c), 0 to sqrt(2),
  /// c the largest normalised cross-correlation with a dilated window that overlaps the shapelet as a whole; a flat
  /// window has c = 0. A series shorter than a shapelet is extended by its last value. `threads` is 1 or more; the
  /// result does not depend on it.
  Eigen::MatrixXf Distances(const std::vector<Eigen::VectorXf>& series, int threads) const;

 private:
  struct Shapelet {
    Eigen::VectorXf values;  ///< z-normalised
    int dilation;            ///< samples between two values
  };
  std::vector<Shapelet> shapelets_;  ///< in the order of their dilations, which share the windows' deviations
};

/// `features` [N, D] with each column at a mean of 0 and a standard deviation of 1, so that all count alike; a constant
/// column becomes 0.
Eigen::MatrixXf Standardised(const Eigen::Ref<const Eigen::MatrixXf>& features);

}  // namespace contact_shapelets::core
