#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// What the systems of an evaluation have in common: they cluster series that they have learned from, and others.

namespace contact_shapelets::evaluation {

/// A method under evaluation. Series may differ in length. Methods use one thread.
class Clusterer {
 public:
  Clusterer() = default;
  virtual ~Clusterer() = default;
  Clusterer(const Clusterer&) = delete;
  Clusterer& operator=(const Clusterer&) = delete;

  /// Learns from `train` (N series) and splits it into `clusters` (at least 2); returns the labels [N]. Equal seeds
  /// give equal results. \throws std::invalid_argument where the method cannot work on these series.
  virtual Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) = 0;

  /// What the method looks at, one row for each of `series`. Call Fit() first, also for the two below.
  virtual Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const = 0;

  /// For each row of `features`, from Transform(), the cluster of Fit() with the nearest centroid.
  virtual Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const = 0;

  /// Splits the rows of `features`, from Transform(), into as many new clusters as Fit() had.
  virtual Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const = 0;
};

}  // namespace contact_shapelets::evaluation
