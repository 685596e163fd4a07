#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "evaluation/clusterer.h"

/// \file
/// Methods that learn features and leave the clustering to K-means.

namespace contact_shapelets::evaluation {

/// A method that clusters its features by K-means with 20 restarts. Such methods differ in their features alone.
class FeatureClusterer : public Clusterer {
 public:
  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;
  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;
  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;

 protected:
  /// Learns the features from `train`, before the first call of Transform().
  virtual void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) = 0;

 private:
  int clusters_ = 0;
  std::uint64_t seed_ = 0;
  Eigen::MatrixXf centroids_;
};

}  // namespace contact_shapelets::evaluation
