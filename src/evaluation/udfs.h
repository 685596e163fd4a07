#pragma once

#include <Eigen/Core>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// UDFS: Yang, Shen, Ma, Huang, Zhou: l2,1-Norm Regularized Discriminative Feature Selection for Unsupervised Learning,
/// IJCAI 2011. Every sample of a series is a feature. UDFS keeps those that tell local groups of series apart.

namespace contact_shapelets::evaluation {

/// Parameters of SelectFeatures() and UdfsClusterer.
struct UdfsOptions {
  int neighbours = 5;       ///< k, nearest neighbours of each series, at least 1; all others if there are fewer
  double ridge = 0.1;       ///< lambda of B_i, above 0
  double sparsity = 0.1;    ///< gamma of the l2,1 norm, above 0
  int iterations = 100;     ///< greatest number of rounds, at least 1
  double kept_part = 0.25;  ///< part of the features that UdfsClusterer keeps, (0, 1]
};

/// The result of SelectFeatures().
struct UdfsResult {
  Eigen::VectorXd weights;         ///< [D] length of each feature's row w_r of W
  std::vector<double> objectives;  ///< tr(W^T M W) + gamma |W|_{2,1} after each round; it never rises
};

/// Weighs the D features of `points` [N, D], one point per row, by how well they tell `clusters` groups apart.
///
/// Minimises tr(W^T M W) + gamma |W|_{2,1} under W^T W = I, with
///   M = sum_i X_i H B_i H X_i^T,  B_i = (H X_i^T X_i H + lambda I)^-1,  H = I - 1 1^T / (k + 1).
/// X_i holds point i and its k nearest neighbours. Each round sets W to the eigenvectors of the `clusters` smallest
/// eigenvalues of M + gamma D, and then D_rr = 1 / (2 |w_r|).
/// \throws std::invalid_argument if there are fewer than 2 points or fewer features than clusters, or an option is out
/// of
///   range.
UdfsResult SelectFeatures(const Eigen::Ref<const Eigen::MatrixXd>& points, int clusters, const UdfsOptions& options);

/// K-means on the samples with the greatest weights by SelectFeatures().
class UdfsClusterer : public FeatureClusterer {
 public:
  /// Selects samples by `options`.
  explicit UdfsClusterer(const UdfsOptions& options) : options_(options) {}
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;
  /// Indices of the samples kept, in ascending order.
  const std::vector<int>& kept() const { return kept_; }

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;

 private:
  UdfsOptions options_;
  int length_ = 0;
  std::vector<int> kept_;
};

}  // namespace contact_shapelets::evaluation
