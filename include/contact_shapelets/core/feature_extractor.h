#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact_shapelets/core/shapelet.h"

/// \file
/// The similarity and t-SNE layers of the paper, for any number of shapelets of individual length and dilation.

namespace contact_shapelets::core {

/// The best matches of K shapelets in one series. A shapelet has none if it is constant or all windows are flat.
struct ShapeletDistances {
  Eigen::VectorXf distances;    ///< F [K], in [0, 2]: 1 - best normalised cross-correlation; 1 if there is no match
  Eigen::VectorXf memberships;  ///< q [K], equation 4, sum 1
  Eigen::VectorXi match_start;  ///< [K] first sample of the matched window; -1 if there is no match
  Eigen::VectorXi match_span;   ///< [K] samples that the matched window spans; 0 if there is no match
};

/// Working memory of FeatureExtractor. Keep it from one series to the next to save allocations. Each thread needs its
/// own.
class FeatureMemory {
 public:
  FeatureMemory();
  ~FeatureMemory();
  /// Takes over the arrays of another, which must not be used then.
  FeatureMemory(FeatureMemory&&) noexcept;
  /// Takes over the arrays of another, which must not be used then.
  FeatureMemory& operator=(FeatureMemory&&) noexcept;

  struct Arrays;
  /// For FeatureExtractor alone.
  Arrays& arrays() { return *arrays_; }

 private:
  std::unique_ptr<Arrays> arrays_;
};

/// Computes the distances of series to a fixed list of shapelets. Several threads may use it at the same time.
class FeatureExtractor {
 public:
  /// Prepares `shapelets`. A window never matches if its standard deviation is at most `flat_fraction` [0, 1) times
  /// that of the series. \throws std::invalid_argument if there is no shapelet, or one has fewer than 2 values, a value
  /// that is not finite, or a dilation below 1.
  FeatureExtractor(const std::vector<Shapelet>& shapelets, double flat_fraction);

  /// Computes distances and memberships of one series [Q >= 2]. A series shorter than a shapelet is extended by its
  /// last value. \throws std::invalid_argument if a value is not finite or Q < 2.
  ShapeletDistances Compute(const Eigen::Ref<const Eigen::VectorXf>& series) const;

  /// The same with `memory` of the caller. Once that is as large as a series needs, allocates only the result.
  ShapeletDistances Compute(const Eigen::Ref<const Eigen::VectorXf>& series, FeatureMemory* memory) const;

  /// Returns F [N, K] of N series, one per row, as Compute() gives it. `threads` is 1 or more; the result does not
  /// depend on it.
  Eigen::MatrixXf Distances(const std::vector<Eigen::VectorXf>& series, int threads) const;

  /// Number of shapelets K.
  int shapelet_count() const { return shapelet_count_; }

 private:
  struct Group;
  std::shared_ptr<const std::vector<Group>> groups_;  ///< constant, so copies share them
  int shapelet_count_;
  double flat_fraction_;
};

}  // namespace contact_shapelets::core
