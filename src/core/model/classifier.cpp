#include "contact_shapelets/core/classifier.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/stream/resampler.h"

namespace contact_shapelets::core {
namespace {

Model Checked(Model model) {
  const std::string faults = model.Faults();
  if (!faults.empty()) throw std::invalid_argument("the model cannot be used: " + faults);
  return model;
}

/// Returns the share of the nearest cluster if each has the weight 1 / distance^2, as in fuzzy c-means (Bezdek 1981).
float NearestShare(const Eigen::Ref<const Eigen::VectorXf>& distances, Eigen::Index nearest) {
  const float least = std::max(distances[nearest], 1e-6F);
  return 1.0F / (least / distances.array().max(1e-6F)).square().sum();
}

/// Returns the force of `episode` at another period. Each value is a mean over its period, as in the segmentation.
Eigen::VectorXf ForceAt(double period, const Episode& episode) {
  const auto nanoseconds = [](double seconds) { return static_cast<Nanoseconds>(std::llround(1e9 * seconds)); };
  std::vector<WrenchSample> samples;
  samples.reserve(static_cast<std::size_t>(episode.force.size()));
  for (Eigen::Index index = 0; index < episode.force.size(); ++index) {
    const double middle = (static_cast<double>(index) + 0.5) * episode.sample_period;
    samples.push_back({nanoseconds(middle), Eigen::Vector3d(episode.force[index], 0.0, 0.0)});
  }
  return ResampledMagnitude(samples, 0, nanoseconds(episode.duration()), period, Eigen::Vector3d::Zero());
}

}  // namespace

Classifier::Classifier(Model model)
    : model_(Checked(std::move(model))), extractor_(model_.shapelets, model_.flat_fraction) {}

Classification Classifier::Classify(const Episode& episode) const {
  FeatureMemory memory;
  return Classify(episode, &memory);
}

Classification Classifier::Classify(const Episode& episode, FeatureMemory* memory) const {
  if (!IsSamplePeriod(episode.sample_period)) throw std::invalid_argument("its sample period is not in [0.0001, 1] s");
  const bool same_period = std::abs(episode.sample_period / model_.sample_period - 1.0) < 1e-6;
  if (!same_period && episode.force.size() < 2) throw std::invalid_argument("the episode has fewer than 2 samples");
  Classification result;
  result.features = same_period ? extractor_.Compute(episode.force, memory)
                                : extractor_.Compute(ForceAt(model_.sample_period, episode), memory);

  const Eigen::VectorXf features = model_.Features(result.features.distances.transpose()).transpose();
  Eigen::VectorXf distances(model_.clusters.size());
  for (Eigen::Index index = 0; index < distances.size(); ++index) {
    distances[index] = (model_.clusters[static_cast<std::size_t>(index)].centroid - features).norm();
  }
  Eigen::Index nearest = 0;
  const float least = distances.minCoeff(&nearest);
  Diagnosis& diagnosis = result.diagnosis;
  diagnosis.nearest_cluster = static_cast<int>(nearest);
  diagnosis.novelty = least / model_.clusters[static_cast<std::size_t>(nearest)].novelty_limit;
  diagnosis.cluster = diagnosis.novelty > 1.0F ? -1 : diagnosis.nearest_cluster;
  diagnosis.event = model_.EventOf(diagnosis.cluster);
  diagnosis.confidence = NearestShare(distances, nearest);
  return result;
}

void Classifier::NameCluster(int cluster, const std::string& label) {
  if (cluster < 0 || cluster >= static_cast<int>(model_.clusters.size())) {
    throw std::invalid_argument("there is no cluster " + std::to_string(cluster) + ": the model has clusters 0 to " +
                                std::to_string(model_.clusters.size() - 1));
  }
  if (label.empty()) throw std::invalid_argument("the label of cluster " + std::to_string(cluster) + " is empty");
  if (label.size() > kLongestLabel) {
    throw std::invalid_argument("the label of cluster " + std::to_string(cluster) + " has more than " +
                                std::to_string(kLongestLabel) + " bytes");
  }
  model_.clusters[static_cast<std::size_t>(cluster)].label = label;
}

}  // namespace contact_shapelets::core
