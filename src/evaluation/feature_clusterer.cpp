#include "evaluation/feature_clusterer.h"

#include <utility>

#include "core/clustering/kmeans.h"

namespace contact_shapelets::evaluation {
namespace {

core::KMeansResult SharedKMeans(const Eigen::Ref<const Eigen::MatrixXf>& features, int clusters, std::uint64_t seed) {
  core::KMeansOptions options;
  options.clusters = clusters;
  options.restarts = 20;
  options.seed = seed;
  return core::KMeans(features, options);
}

}  // namespace

Eigen::VectorXi FeatureClusterer::Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  Learn(train, clusters, seed);
  clusters_ = clusters;
  seed_ = seed;
  core::KMeansResult result = SharedKMeans(Transform(train), clusters, seed);
  centroids_ = std::move(result.centroids);
  return result.labels;
}

Eigen::VectorXi FeatureClusterer::Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return core::NearestCentroids(centroids_, features);
}

Eigen::VectorXi FeatureClusterer::ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return SharedKMeans(features, clusters_, seed_).labels;
}

}  // namespace contact_shapelets::evaluation
