#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "evaluation/clusterer.h"

/// \file
/// K-medoids under dynamic time warping: Sakoe, Chiba: Dynamic Programming Algorithm Optimization for Spoken Word
/// Recognition, IEEE TASSP 1978; Kaufman, Rousseeuw: Clustering by Means of Medoids, 1987.

namespace contact_shapelets::evaluation {

/// Parameters of DtwClusterer.
struct DtwOptions {
  double band = 0.1;     ///< greatest warp as a part of the series' length, [0, 1]
  int restarts = 20;     ///< random starts; the one of least summed distance is kept; at least 1
  int iterations = 100;  ///< rounds per start at most, at least 1
};

/// The dynamic time warping distance of `x` and `y` [Q >= 1], of equal length: the root of the least sum of squared
/// differences over all warping paths that stay within `band` samples (0 or more) of the diagonal.
/// \throws std::invalid_argument if the lengths differ or are 0.
double DtwDistance(const Eigen::Ref<const Eigen::VectorXf>& x, const Eigen::Ref<const Eigen::VectorXf>& y, int band);

/// A partition around medoids.
struct KMedoidsResult {
  std::vector<int> medoids;  ///< [C] items
  Eigen::VectorXi labels;    ///< [N] index into `medoids`
  double cost = 0.0;         ///< sum of the distances to the assigned medoids
};

/// Splits N items into `clusters` groups around medoids, given their `distances` [N, N]: assigns each item to its
/// nearest medoid and moves each medoid to the item of least summed distance, in turn, from seeded random starts.
/// \throws std::invalid_argument if there are fewer items than clusters, or an option is out of range.
KMedoidsResult KMedoids(const Eigen::Ref<const Eigen::MatrixXd>& distances, int clusters, const DtwOptions& options,
                        std::uint64_t seed);

/// K-medoids on the z-normalised series, stretched to one length, under dynamic time warping.
class DtwClusterer : public Clusterer {
 public:
  /// \param options see there
  explicit DtwClusterer(const DtwOptions& options) : options_(options) {}

  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;
  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;
  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;

 private:
  int Band() const;
  Eigen::MatrixXd AllDistances(const Eigen::Ref<const Eigen::MatrixXf>& rows) const;

  DtwOptions options_;
  int clusters_ = 0;
  std::uint64_t seed_ = 0;
  int length_ = 0;
  Eigen::MatrixXf medoids_;  ///< [C, length]
};

}  // namespace contact_shapelets::evaluation
