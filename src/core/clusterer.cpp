#include "contact_shapelets/core/clusterer.h"

#include <algorithm>
#include <stdexcept>

#include "contact_shapelets/core/data_set.h"
#include "contact_shapelets/core/feature_extractor.h"
#include "contact_shapelets/core/k_shape.h"
#include "contact_shapelets/core/kmeans.h"
#include "contact_shapelets/core/series.h"
#include "contact_shapelets/core/udfs.h"
#include "contact_shapelets/core/uslm.h"

namespace contact_shapelets::core {
namespace {

KMeansResult SharedKMeans(const Eigen::Ref<const Eigen::MatrixXf>& features, int clusters, std::uint64_t seed) {
  KMeansOptions options;
  options.clusters = clusters;
  options.restarts = 20;
  options.seed = seed;
  return KMeans(features, options);
}

/// K-means on the z-normalised series themselves.
class RawClusterer : public FeatureClusterer {
 public:
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override {
    return EqualLengthRows(series, length_);
  }

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int /*clusters*/, std::uint64_t /*seed*/) override {
    length_ = MedianLength(train);
  }

 private:
  int length_ = 0;
};

TrainingResult TrainOnSeries(const std::vector<Eigen::VectorXf>& train, const TrainerOptions& options) {
  std::vector<Episode> episodes(train.size());
  for (std::size_t index = 0; index < train.size(); ++index) {
    episodes[index].id = std::to_string(index);
    episodes[index].sample_period = 1.0;
    episodes[index].force = train[index];
  }
  return TrainModel(episodes, options);
}

/// The trainer and classifier of this package. Features are the distances to the learned shapelets and to the random
/// ones, which only vote, side by side.
class StneClusterer : public Clusterer {
 public:
  explicit StneClusterer(const TrainerOptions& options) : options_(options) {}

  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override {
    options_.clusters = clusters;
    options_.seed = seed;
    options_.threads = 1;
    result_ = TrainOnSeries(train, options_);
    return result_.labels;
  }

  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override {
    const Model& model = result_.model;
    Eigen::MatrixXf features(series.size(), model.shapelets.size() + result_.random_shapelets.count());
    features << FeatureExtractor(model.shapelets, model.flat_fraction).Distances(series, 1),
        result_.random_shapelets.Distances(series, 1);
    return features;
  }

  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override {
    const Model& model = result_.model;
    Eigen::MatrixXf centroids(model.clusters.size(), model.shapelets.size());
    for (std::size_t index = 0; index < model.clusters.size(); ++index) {
      centroids.row(static_cast<Eigen::Index>(index)) = model.clusters[index].centroid.transpose();
    }
    return NearestCentroids(centroids, model.Features(features.leftCols(centroids.cols())));
  }

  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override {
    const auto learned = static_cast<Eigen::Index>(result_.model.shapelets.size());
    return VotedLabels(result_, features.leftCols(learned), features.rightCols(features.cols() - learned), options_);
  }

 private:
  TrainerOptions options_;
  TrainingResult result_;
};

/// The paper's method: one scale, attraction alone, diversity, every window, length by the L1 norm, K-means on the
/// distances.
class PaperClusterer : public FeatureClusterer {
 public:
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override {
    return FeatureExtractor(model_.shapelets, model_.flat_fraction).Distances(series, 1);
  }

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override {
    TrainerOptions options;
    options.clusters = clusters;
    options.seed = seed;
    options.threads = 1;
    options.voters = 0;
    options.learner.objective = Objective::kPaper;
    options.learner.scales = {0.4};
    options.learner.flat_fraction = 0.0;
    options.learner.diversity = 0.01;
    options.learner.sparsity = 0.1;
    options.learner.steps = 40;
    model_ = TrainOnSeries(train, options).model;
  }

 private:
  Model model_;
};

/// The number K of the name "udfs_kK", 1 to 999; 0 where it is not of that form.
int UdfsNeighbours(const std::string& name) {
  const std::string prefix = "udfs_k";
  const std::string digits = name.substr(std::min(prefix.size(), name.size()));
  const bool number =
      !digits.empty() && digits.size() <= 3 && digits.find_first_not_of("0123456789") == std::string::npos;
  return name.compare(0, prefix.size(), prefix) == 0 && number ? std::stoi(digits) : 0;
}

}  // namespace

Eigen::VectorXi FeatureClusterer::Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  Learn(train, clusters, seed);
  clusters_ = clusters;
  seed_ = seed;
  KMeansResult result = SharedKMeans(Transform(train), clusters, seed);
  centroids_ = std::move(result.centroids);
  return result.labels;
}

Eigen::VectorXi FeatureClusterer::Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return NearestCentroids(centroids_, features);
}

Eigen::VectorXi FeatureClusterer::ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return SharedKMeans(features, clusters_, seed_).labels;
}

const std::vector<std::string>& ClustererNames() {
  static const std::vector<std::string> names{"kmeans", "udfs", "kshape", "uslm", "nn_stne", "nn_stne_paper"};
  return names;
}

std::unique_ptr<Clusterer> MakeClusterer(const std::string& name, const TrainerOptions& options) {
  if (name == "kmeans") return std::make_unique<RawClusterer>();
  if (name == "udfs") return std::make_unique<UdfsClusterer>(UdfsOptions{});
  if (const int neighbours = UdfsNeighbours(name); neighbours > 0) {
    UdfsOptions udfs;
    udfs.neighbours = neighbours;
    return std::make_unique<UdfsClusterer>(udfs);
  }
  if (name == "kshape") return std::make_unique<KShapeClusterer>();
  if (name == "uslm") return std::make_unique<UslmClusterer>(UslmOptions{});
  if (name == "nn_stne") return std::make_unique<StneClusterer>(options);
  if (name == "nn_stne_paper") return std::make_unique<PaperClusterer>();
  std::string names;
  for (const std::string& known : ClustererNames()) names += known + ", ";
  throw std::invalid_argument("there is no method " + name + "; there are " + names + "and udfs_k1 to udfs_k999");
}

}  // namespace contact_shapelets::core
