#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// Random dilated shapelets (Guillaume, Vrain and Elloumi: Random Dilated Shapelet Transform, ICPRAI 2022), here
/// without labels: subsequences of few samples with gaps between them, drawn from the training series. They are many,
/// and they are not learned. They vote on the clusters beside the learned shapelets, but are not part of a model.

namespace contact_shapelets::core {

/// Shapelets drawn at random from series.
class RandomShapelets {
 public:
  /// Samples of each shapelet; a quarter of the median series, but at least 3, if that is fewer.
  static constexpr int kLength = 9;

  /// Holds no shapelets.
  RandomShapelets() = default;

  /// Draws `count` (0 or more) shapelets from `series`, each of 2 or more finite values. The dilation of each is 2^u,
  /// rounded down. u is uniform from 0 to the value at which the shapelet spans the median series. Equal seeds give
  /// equal shapelets. \throws std::invalid_argument if there is no series, or one with fewer than 2 values.
  RandomShapelets(const std::vector<Eigen::VectorXf>& series, int count, std::uint64_t seed);

  /// Returns how many samples each shapelet spans, [count()].
  Eigen::VectorXf Reaches() const;

  /// Number of shapelets.
  int count() const { return static_cast<int>(shapelets_.size()); }

  /// Returns the distances [N, count()] of `series` (each of 2 or more finite values) to the shapelets: sqrt(1 - c), 0
  /// to sqrt(2). c is the largest normalised cross-correlation with the dilated windows, at full overlap; that with a
  /// flat window is 0. A series shorter than a shapelet is extended by its last value. `threads` is 1 or more; the
  /// result does not depend on it.
  Eigen::MatrixXf Distances(const std::vector<Eigen::VectorXf>& series, int threads) const;

 private:
  struct Shapelet {
    Eigen::VectorXf values;  ///< z-normalised
    int dilation;            ///< samples from one value to the next
  };
  std::vector<Shapelet> shapelets_;  ///< in the order of their dilations: equal dilations share the windows' deviations
};

/// Returns `features` [N, D] with each column scaled to a mean of 0 and a standard deviation of 1, so that all columns
/// count alike. A constant column becomes 0.
Eigen::MatrixXf Standardised(const Eigen::Ref<const Eigen::MatrixXf>& features);

}  // namespace contact_shapelets::core
