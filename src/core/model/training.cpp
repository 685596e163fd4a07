#include "core/model/training.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contact_shapelets/core/feature_extractor.h"
#include "core/clustering/kmeans.h"
#include "core/learning/learner.h"
#include "core/model/cluster_names.h"
#include "core/model/training_digest.h"
#include "core/numerics/parallel.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

/// The uses of a seed in a training.
enum Stream : std::uint32_t { kLearning, kRandomShapelets, kVotingEpisodes, kVotes };

/// Greatest exponents p of the weights scale^-p by which voters prefer short shapelets. Reaches of random shapelets
/// span a greater factor (up to Q / 9) than the learned scales (16), so they need a smaller exponent.
constexpr double kLearnedExponent = 2.0;
constexpr double kRandomExponent = 0.25;
/// Part of the voters that see the learned shapelets, if there are random ones.
constexpr double kLearnedShare = 0.55;

/// Progress of a training after learning the shapelets, after computing the distances, and after the votes.
constexpr double kLearned = 0.9;
constexpr double kMeasured = 0.95;
constexpr double kVoted = 0.98;

/// [N] Rounding errors of the tare make a constant force vary by less than this.
constexpr float kRounding = 1e-9F;

/// Least novelty limit: rounding makes the features of equal episodes differ by less than this.
constexpr float kLeastLimit = 1e-3F;

void CheckEpisodes(const std::vector<Episode>& episodes, int clusters) {
  if (episodes.size() < static_cast<std::size_t>(clusters)) {
    throw std::invalid_argument("there are fewer episodes (" + std::to_string(episodes.size()) + ") than clusters (" +
                                std::to_string(clusters) + ")");
  }
  bool all_flat = true;
  for (const Episode& episode : episodes) {
    if (episode.force.size() < 2) throw std::invalid_argument("episode " + episode.id + " has fewer than 2 samples");
    if (!episode.force.allFinite()) {
      throw std::invalid_argument("episode " + episode.id + " holds a value that is not finite");
    }
    if (std::abs(episode.sample_period - episodes.front().sample_period) > 1e-9) {
      throw std::invalid_argument("episode " + episode.id + " has another sample period than the first one");
    }
    const bool steady = episode.force.maxCoeff() - episode.force.minCoeff() < kRounding;
    all_flat = all_flat && (steady || ZNormalised(episode.force).isZero());
  }
  if (all_flat) throw std::invalid_argument("all episodes are flat: the force never changes in any of them");
}

/// Checks the size of the model before the training, because LoadModel() would refuse a larger one.
void CheckModelSize(const std::vector<Eigen::VectorXf>& series, const TrainerOptions& options) {
  const auto count = static_cast<int>(series.size());
  const int typical_length = MedianLength(series);
  double values = 0.0;
  for (const double scale : options.learner.scales) {
    const int length = std::max(options.learner.shortest, static_cast<int>(scale * typical_length));
    values += static_cast<double>(length) * ShapeletCount(count, typical_length, length, options.clusters);
  }
  if (values <= kMostValues) return;
  throw std::invalid_argument("episodes of " + std::to_string(typical_length) + " samples (median) give shapelets of " +
                              std::to_string(std::llround(values)) + " values, more than " +
                              std::to_string(kMostValues) + ": raise sample_period, or give fewer scales");
}

/// Returns the scale of each shapelet of `model`.
Eigen::VectorXf ScalesOf(const Model& model) {
  Eigen::VectorXf scales(model.shapelets.size());
  for (std::size_t k = 0; k < model.shapelets.size(); ++k) {
    const auto scale = static_cast<std::size_t>(model.shapelets[k].scale);
    scales[static_cast<Eigen::Index>(k)] = static_cast<float>(model.provenance.selected_scales[scale]);
  }
  return scales;
}

float NoveltyLimit(std::vector<float> distances, double quantile, double margin) {
  std::sort(distances.begin(), distances.end());
  const auto last = static_cast<double>(distances.size() - 1);
  const float covered = distances[static_cast<std::size_t>(std::lround(quantile * last))];
  return std::max(static_cast<float>(margin) * covered, kLeastLimit);
}

/// Equal episodes, or a single one, give no limit for their cluster. It takes the median of the other clusters' limits.
void WidenLeastLimits(std::vector<Cluster>* clusters) {
  std::vector<float> limits;
  for (const Cluster& cluster : *clusters) {
    if (cluster.novelty_limit > kLeastLimit) limits.push_back(cluster.novelty_limit);
  }
  if (limits.empty()) return;
  const auto middle = limits.begin() + static_cast<std::ptrdiff_t>(limits.size() / 2);
  std::nth_element(limits.begin(), middle, limits.end());
  for (Cluster& cluster : *clusters) {
    if (cluster.novelty_limit <= kLeastLimit) cluster.novelty_limit = *middle;
  }
}

/// Centroids use only the features of the learned shapelets, so that the classifier needs no random ones.
std::vector<Cluster> FormClusters(const Eigen::Ref<const Eigen::MatrixXf>& features,
                                  const Eigen::Ref<const Eigen::VectorXi>& labels, const TrainerOptions& options) {
  std::vector<Cluster> clusters;
  for (int index = 0; index < options.clusters; ++index) {
    Cluster cluster;
    cluster.size = static_cast<int>((labels.array() == index).count());
    cluster.centroid = Eigen::VectorXf::Zero(features.cols());
    for (Eigen::Index row = 0; row < features.rows(); ++row) {
      if (labels[row] == index) cluster.centroid += features.row(row).transpose() / static_cast<float>(cluster.size);
    }
    std::vector<float> distances;
    for (Eigen::Index row = 0; row < features.rows(); ++row) {
      if (labels[row] == index) distances.push_back((features.row(row).transpose() - cluster.centroid).norm());
    }
    cluster.novelty_limit = NoveltyLimit(distances, options.novelty_quantile, options.novelty_margin);
    clusters.push_back(std::move(cluster));
  }
  WidenLeastLimits(&clusters);
  return clusters;
}

/// Returns the clusters of all training episodes. If there are more than `voting_episodes`, draws as many to vote on.
/// The others go to the nearest centroid of these.
Eigen::VectorXi TrainingLabels(const Training& training, const std::vector<Eigen::VectorXf>& series,
                               const Eigen::Ref<const Eigen::MatrixXf>& distances, const TrainerOptions& options,
                               const VotesCallback& on_votes) {
  const int threads = ThreadCount(options.threads);
  const auto count = static_cast<int>(series.size());
  if (count <= options.voting_episodes) {
    return VotedLabels(training, distances, training.random_shapelets.Distances(series, threads), options, on_votes);
  }
  std::vector<int> drawn = Random(StreamSeed(options.seed, kVotingEpisodes)).Sample(count, options.voting_episodes);
  std::sort(drawn.begin(), drawn.end());
  std::vector<Eigen::VectorXf> drawn_series;
  Eigen::MatrixXf drawn_distances(drawn.size(), distances.cols());
  for (std::size_t index = 0; index < drawn.size(); ++index) {
    drawn_series.push_back(series[static_cast<std::size_t>(drawn[index])]);
    drawn_distances.row(static_cast<Eigen::Index>(index)) = distances.row(drawn[index]);
  }
  const Eigen::VectorXi voted = VotedLabels(
      training, drawn_distances, training.random_shapelets.Distances(drawn_series, threads), options, on_votes);
  Eigen::MatrixXf centroids(options.clusters, distances.cols());
  const std::vector<Cluster> clusters = FormClusters(training.model.Features(drawn_distances), voted, options);
  for (int index = 0; index < options.clusters; ++index) centroids.row(index) = clusters[index].centroid.transpose();
  Eigen::VectorXi labels = NearestCentroids(centroids, training.model.Features(distances));
  for (std::size_t index = 0; index < drawn.size(); ++index) {
    labels[drawn[index]] = voted[static_cast<Eigen::Index>(index)];
  }
  return labels;
}

std::vector<ShapeletBank> LearnBanksWithProgress(const std::vector<Eigen::VectorXf>& series,
                                                 const TrainerOptions& options, const ProgressCallback& progress) {
  bool cancelled = false;
  const double total = static_cast<double>(options.learner.scales.size()) * std::max(1, options.learner.steps);
  const auto on_step = [&](int bank, int step, double objective) {
    if (!progress) return true;
    const double done = (static_cast<double>(bank) * options.learner.steps + step + 1) / total;
    cancelled = !progress({bank, step, objective, kLearned * done});
    return !cancelled;
  };
  std::vector<ShapeletBank> banks =
      LearnBanks(series, options.clusters, options.learner, StreamSeed(options.seed, kLearning),
                 ThreadCount(options.threads), on_step);
  if (cancelled) throw Cancelled();
  if (banks.empty()) {
    throw std::invalid_argument("too few windows that are not flat: more or longer episodes are needed");
  }
  return banks;
}

}  // namespace

Eigen::VectorXi VotedLabels(const Training& training, const Eigen::Ref<const Eigen::MatrixXf>& distances,
                            const Eigen::Ref<const Eigen::MatrixXf>& random_distances, const TrainerOptions& options,
                            const VotesCallback& on_votes) {
  const Model& model = training.model;
  if (options.voters == 0) {
    KMeansOptions kmeans;
    kmeans.clusters = options.clusters;
    kmeans.restarts = options.kmeans_restarts;
    kmeans.seed = StreamSeed(options.seed, kVotes);
    return KMeans(model.Features(distances), kmeans).labels;
  }
  const auto learned_voters = static_cast<int>(std::lround(kLearnedShare * options.voters));
  const int random_voters = random_distances.cols() > 0 ? options.voters - learned_voters : 0;
  const std::vector<View> views{
      {model.Features(distances), ScalesOf(model), options.voters - random_voters, kLearnedExponent},
      {Standardised(random_distances), training.random_shapelets.Reaches(), random_voters, kRandomExponent}};
  ConsensusOptions consensus;
  consensus.clusters = options.clusters;
  consensus.restarts = options.kmeans_restarts;
  consensus.seed = StreamSeed(options.seed, kVotes);
  return ConsensusLabels(views, consensus, ThreadCount(options.threads), on_votes);
}

Training Train(const std::vector<Episode>& episodes, const TrainerOptions& options, const ProgressCallback& progress) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
  CheckEpisodes(episodes, options.clusters);
  std::vector<Eigen::VectorXf> series;
  std::vector<std::string> outcomes;
  for (const Episode& episode : episodes) {
    series.push_back(episode.force);
    outcomes.push_back(episode.outcome);
  }
  CheckModelSize(series, options);

  Training training;
  Model& model = training.model;
  const std::vector<ShapeletBank> banks = LearnBanksWithProgress(series, options, progress);
  model.shapelets = CutShapelets(banks, options.learner.shortest);
  model.sample_period = episodes.front().sample_period;
  model.flat_fraction = options.learner.flat_fraction;
  if (!options.log_distances) model.log_offset = 0.0;
  for (const ShapeletBank& bank : banks) model.provenance.selected_scales.push_back(bank.scale);

  const auto scales = static_cast<int>(options.learner.scales.size());
  const auto report = [&](double done) {
    const TrainingProgress state{scales, 0, banks.back().objective, done};
    if (progress && !progress(state)) throw Cancelled();
  };
  const Eigen::MatrixXf distances =
      FeatureExtractor(model.shapelets, model.flat_fraction).Distances(series, ThreadCount(options.threads));
  report(kMeasured);
  training.random_shapelets = RandomShapelets(series, options.voters > 0 ? options.random_shapelets : 0,
                                              StreamSeed(options.seed, kRandomShapelets));
  training.labels = TrainingLabels(training, series, distances, options,
                                   [&](double votes) { report(kMeasured + (kVoted - kMeasured) * votes); });
  report(kVoted);
  model.clusters = FormClusters(model.Features(distances), training.labels, options);
  const std::vector<std::string> names = NameClusters(training.labels, outcomes, options.clusters);
  for (std::size_t index = 0; index < names.size(); ++index) {
    model.clusters[index].label = names[index].substr(0, kLongestLabel);
  }

  model.id = TrainingDigest(episodes, options);
  model.provenance.objective = options.learner.objective == Objective::kPaper ? "paper" : "contrastive";
  model.provenance.seed = options.seed;
  model.provenance.training_episodes = static_cast<int>(episodes.size());
  model.provenance.typical_duration = MedianLength(series) * model.sample_period;
  if (progress) progress({scales, 0, banks.back().objective, 1.0});
  return training;
}

}  // namespace contact_shapelets::core
