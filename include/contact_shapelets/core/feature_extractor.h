#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact_shapelets/core/shapelet.h"

/// \file
/// The similarity and t-SNE layers of the paper, for any number of shapelets of individual length and dilation.

namespace contact_shapelets::core {

/// How well each of K shapelets matched one series.
struct ShapeletDistances {
  Eigen::VectorXf distances;    ///< F [K], in [0, 2]: 1 - best normalised cross-correlation
  Eigen::VectorXf memberships;  ///< q [K], equation 4, sum 1
  Eigen::VectorXi match_start;  ///< [K] first sample of the matched window; -1 where no window counts
  Eigen::VectorXi match_span;   ///< [K] samples from the window's first to behind its last
};

/// What FeatureExtractor works in: kept from one series to the next, so that little is allocated. One per thread.
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

/// Computes the distances of series to a fixed list of shapelets. Safe to use from several threads at the same time.
class FeatureExtractor {
 public:
  /// Prepares `shapelets`; windows whose standard deviation is under `flat_fraction` [0, 1) of the series' never match.
  /// \throws std::invalid_argument where there is no shapelet, or one has under 2 values or a dilation under 1.
  FeatureExtractor(const std::vector<Shapelet>& shapelets, double flat_fraction);

  /// F of one series [Q >= 2]. A series shorter than a shapelet is extended by its last value.
  /// \throws std::invalid_argument where a value is not finite or Q < 2.
  ShapeletDistances Compute(const Eigen::Ref<const Eigen::VectorXf>& series) const;

  /// The same in memory of the caller: allocates nothing but the result once that is as large as a series needs.
  ShapeletDistances Compute(const Eigen::Ref<const Eigen::VectorXf>& series, FeatureMemory* memory) const;

  /// F [N, K] of N series, one per row, as Compute() gives it. `threads` is 1 or more; the result does not depend on
  /// it.
  Eigen::MatrixXf Distances(const std::vector<Eigen::VectorXf>& series, int threads) const;

  /// Number of shapelets K.
  int shapelet_count() const { return shapelet_count_; }

 private:
  struct Group;
  std::shared_ptr<const std::vector<Group>> groups_;  ///< never changed, so that copies share them
  int shapelet_count_;
  double flat_fraction_;
};

}  // namespace contact_shapelets::core
