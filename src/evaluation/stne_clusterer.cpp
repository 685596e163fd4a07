#include "evaluation/stne_clusterer.h"

#include <string>

#include "contact_shapelets/core/feature_extractor.h"
#include "core/clustering/kmeans.h"
#include "core/model/training.h"

namespace contact_shapelets::evaluation {
namespace {

core::Training TrainOnSeries(const std::vector<Eigen::VectorXf>& series, const core::TrainerOptions& options) {
  std::vector<core::Episode> episodes(series.size());
  for (std::size_t index = 0; index < series.size(); ++index) {
    episodes[index].id = std::to_string(index);
    episodes[index].sample_period = 1.0;
    episodes[index].force = series[index];
  }
  return core::Train(episodes, options);
}

}  // namespace

StneClusterer::StneClusterer(const core::TrainerOptions& options)
    : options_(options), training_(std::make_unique<core::Training>()) {}

StneClusterer::~StneClusterer() = default;

Eigen::VectorXi StneClusterer::Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  options_.clusters = clusters;
  options_.seed = seed;
  options_.threads = 1;
  *training_ = TrainOnSeries(train, options_);
  return training_->labels;
}

Eigen::MatrixXf StneClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  const core::Model& model = training_->model;
  const core::RandomShapelets& random_shapelets = training_->random_shapelets;
  Eigen::MatrixXf features(series.size(), model.shapelets.size() + random_shapelets.count());
  features << core::FeatureExtractor(model.shapelets, model.flat_fraction).Distances(series, 1),
      random_shapelets.Distances(series, 1);
  return features;
}

Eigen::VectorXi StneClusterer::Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  const core::Model& model = training_->model;
  Eigen::MatrixXf centroids(model.clusters.size(), model.shapelets.size());
  for (std::size_t index = 0; index < model.clusters.size(); ++index) {
    centroids.row(static_cast<Eigen::Index>(index)) = model.clusters[index].centroid.transpose();
  }
  return core::NearestCentroids(centroids, model.Features(features.leftCols(centroids.cols())));
}

Eigen::VectorXi StneClusterer::ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  const auto learned = static_cast<Eigen::Index>(training_->model.shapelets.size());
  return core::VotedLabels(*training_, features.leftCols(learned), features.rightCols(features.cols() - learned),
                           options_);
}

}  // namespace contact_shapelets::evaluation
