#include "contact_shapelets/core/model.h"

#include <algorithm>
#include <sstream>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/learner_options.h"
#include "core/numerics/interval.h"

namespace contact_shapelets::core {
namespace {

/// No value of a z-normalised shapelet exceeds the root of the number of values.
constexpr float kGreatestValue = 1e4F;
/// Features are distances up to 2, or logarithms down to that of the least log offset, -14.
constexpr float kGreatestFeature = 100.0F;
constexpr Interval kNoveltyLimits{1e-6, 1e9};
constexpr Interval kLogOffsets{1e-6, 1.0};
constexpr Interval kScales{0.0, 1.0, true, true};
constexpr Interval kDurations{0.0, 1e7};
/// [ns] Latest time that a message's stamp can hold.
constexpr Nanoseconds kLatest = 4'294'967'295'999'999'999;

bool Within(const Eigen::Ref<const Eigen::VectorXf>& values, float greatest) {
  return values.size() == 0 || values.cwiseAbs().maxCoeff() <= greatest;
}

void CheckShapelet(const Shapelet& shapelet, std::ostream& faults) {
  const auto values = static_cast<double>(shapelet.values.size());
  if (values < 2) faults << "has fewer than 2 values\n";
  if (!shapelet.values.allFinite()) {
    faults << "holds a value that is not finite\n";
  } else if (!Within(shapelet.values, kGreatestValue)) {
    faults << "holds a value that is not in [-10000, 10000]\n";
  }
  if (shapelet.scale < 0 || shapelet.scale >= kMostScales) faults << "has a scale that is not in [0, 99]\n";
  if (shapelet.dilation < 1) faults << "has a dilation below 1\n";
  if (values >= 2 && shapelet.dilation >= 1 && (values - 1) * shapelet.dilation + 1 > kGreatestReach) {
    faults << "reaches over more than " << kGreatestReach << " samples\n";
  }
}

void CheckCluster(const Cluster& cluster, std::size_t shapelets, std::ostream& faults) {
  if (cluster.centroid.size() != static_cast<Eigen::Index>(shapelets)) {
    faults << "has " << cluster.centroid.size() << " features, but there are " << shapelets << " shapelets\n";
  }
  if (!cluster.centroid.allFinite()) {
    faults << "holds a value that is not finite\n";
  } else if (!Within(cluster.centroid, kGreatestFeature)) {
    faults << "holds a value that is not in [-100, 100]\n";
  }
  if (!kNoveltyLimits.Contains(cluster.novelty_limit)) {
    faults << "has a novelty limit that is not in " << kNoveltyLimits.Text() << '\n';
  }
  if (cluster.size < 0) faults << "has a size that is not in [0, 2147483647]\n";
  if (cluster.label.size() > kLongestLabel) faults << "has a label of more than " << kLongestLabel << " bytes\n";
}

/// Writes the lines of `item_faults`, each after the name of the item.
void Add(const std::string& item, const std::ostringstream& item_faults, std::ostream& faults) {
  std::istringstream lines(item_faults.str());
  for (std::string line; std::getline(lines, line);) faults << item << ' ' << line << '\n';
}

/// Returns false if there are too many shapelets or clusters to check each.
bool CheckSizes(const Model& model, std::ostream& faults) {
  const auto count = [&faults](const char* what, double size, double greatest) {
    if (size == 0.0) faults << "the model has no " << what << '\n';
    if (size > greatest) faults << "the model has more than " << static_cast<long>(greatest) << ' ' << what << "s\n";
    return size <= greatest;
  };
  const bool few = count("shapelet", static_cast<double>(model.shapelets.size()), kMostShapelets);
  if (!count("cluster", static_cast<double>(model.clusters.size()), kMostClusters) || !few) return false;
  double values = 0.0;
  double features = 0.0;
  for (const Shapelet& shapelet : model.shapelets) values += static_cast<double>(shapelet.values.size());
  for (const Cluster& cluster : model.clusters) features += static_cast<double>(cluster.centroid.size());
  if (values > kMostValues) faults << "the shapelets have more than " << kMostValues << " values together\n";
  if (features > kMostValues) faults << "the clusters have more than " << kMostValues << " features together\n";
  return values <= kMostValues && features <= kMostValues;
}

void CheckProvenance(const Provenance& provenance, std::ostream& faults) {
  if (provenance.sources.size() > kMostSources) faults << "the model has more than " << kMostSources << " sources\n";
  if (std::any_of(provenance.sources.begin(), provenance.sources.end(),
                  [](const std::string& source) { return source.size() > kLongestPath; })) {
    faults << "a source has more than " << kLongestPath << " bytes\n";
  }
  if (provenance.objective.size() > kLongestLabel) {
    faults << "the objective has more than " << kLongestLabel << " bytes\n";
  }
  const std::vector<double>& scales = provenance.selected_scales;
  if (scales.size() > kMostScales) faults << "the model has more than " << kMostScales << " scales\n";
  if (!std::all_of(scales.begin(), scales.end(), [](double scale) { return kScales.Contains(scale); })) {
    faults << "a scale is not in " << kScales.Text() << '\n';
  }
  if (provenance.training_episodes < 0) faults << "the number of training episodes is not in [0, 2147483647]\n";
  if (!kDurations.Contains(provenance.typical_duration)) {
    faults << "the typical duration is not in " << kDurations.Text() << " s\n";
  }
  if (provenance.trained < 0 || provenance.trained > kLatest)
    faults << "the time of training is not in a stamp's range\n";
}

}  // namespace

Eigen::MatrixXf Model::Features(const Eigen::Ref<const Eigen::MatrixXf>& distances) const {
  if (log_offset == 0.0) return distances.cwiseMax(0.0F);
  return (distances.array().max(0.0F) + static_cast<float>(log_offset)).log().matrix();
}

std::string Model::EventOf(int cluster) const {
  if (cluster < 0 || cluster >= static_cast<int>(clusters.size())) return "unknown";
  const std::string& label = clusters[static_cast<std::size_t>(cluster)].label;
  return label.empty() ? "cluster_" + std::to_string(cluster) : label;
}

std::string Model::Faults() const {
  std::ostringstream faults;
  if (id.size() > kLongestLabel) faults << "the id has more than " << kLongestLabel << " bytes\n";
  if (!IsSamplePeriod(sample_period)) faults << "the sample period is not in [0.0001, 1] s\n";
  if (!(flat_fraction >= 0.0 && flat_fraction < 1.0)) faults << "the flat fraction is not in [0, 1)\n";
  if (log_offset != 0.0 && !kLogOffsets.Contains(log_offset)) {
    faults << "the log offset is not 0 or in " << kLogOffsets.Text() << '\n';
  }
  CheckProvenance(provenance, faults);
  faults << preparation.Faults();
  if (!CheckSizes(*this, faults)) return faults.str();
  for (std::size_t index = 0; index < shapelets.size(); ++index) {
    std::ostringstream item;
    CheckShapelet(shapelets[index], item);
    Add("shapelet " + std::to_string(index), item, faults);
  }
  for (std::size_t index = 0; index < clusters.size(); ++index) {
    std::ostringstream item;
    CheckCluster(clusters[index], shapelets.size(), item);
    Add("cluster " + std::to_string(index), item, faults);
  }
  return faults.str();
}

}  // namespace contact_shapelets::core
