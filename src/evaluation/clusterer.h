#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// The interface of the methods that an evaluation compares.

namespace contact_shapelets::evaluation {

/// A method under evaluation. It clusters the series that it learns from, and other series. Series may differ in
/// length. Methods use one thread.
class Clusterer {
 public:
  Clusterer() = default;
  virtual ~Clusterer() = default;
  Clusterer(const Clusterer&) = delete;
  Clusterer& operator=(const Clusterer&) = delete;

  /// Learns from `train` (N series) and splits it into `clusters` (at least 2). Returns the labels [N]. Equal seeds
  /// give equal results. Call it before the other functions. \throws std::invalid_argument if the method cannot work on
  /// these series.
  virtual Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) = 0;

  /// Returns the features of `series`, one row for each.
  virtual Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const = 0;

  /// Returns the cluster of Fit() with the nearest centroid for each row of `features` from Transform().
  virtual Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const = 0;

  /// Splits the rows of `features` from Transform() into as many new clusters as Fit() did, and returns their labels.
  virtual Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const = 0;
};

}  // namespace contact_shapelets::evaluation
