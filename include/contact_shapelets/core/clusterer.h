#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "contact_shapelets/core/trainer.h"

/// \file
/// What the systems of an evaluation have in common: they cluster series that they have learned from, and others.

namespace contact_shapelets::core {

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

/// A method that differs from others in its features alone: K-means with 20 restarts on them.
class FeatureClusterer : public Clusterer {
 public:
  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;
  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;
  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;

 protected:
  /// Learns what Transform() needs.
  virtual void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) = 0;

 private:
  int clusters_ = 0;
  std::uint64_t seed_ = 0;
  Eigen::MatrixXf centroids_;
};

/// Names of the methods that are compared by default, all known to MakeClusterer().
const std::vector<std::string>& ClustererNames();

/// The method `name`: "kmeans" on the z-normalised series; "udfs" (udfs.h) with 5 neighbours, "udfs_k1" to "udfs_k999"
/// with as many; "kshape" (k_shape.h); "uslm" (uslm.h); "nn_stne", this package's trainer with `options`;
/// "nn_stne_paper", the paper's objective and distances with one scale and none of the additions, whatever `options`
/// says. \throws std::invalid_argument naming the methods where there is none of that name.
std::unique_ptr<Clusterer> MakeClusterer(const std::string& name, const TrainerOptions& options);

}  // namespace contact_shapelets::core
