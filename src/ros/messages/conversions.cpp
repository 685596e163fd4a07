#include "ros/messages/conversions.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/messages/preparation_message.h"

namespace contact_shapelets {
namespace {

std::vector<float> ToList(const Eigen::Ref<const Eigen::VectorXf>& values) {
  return std::vector<float>(values.data(), values.data() + values.size());
}

Eigen::VectorXf FromList(const std::vector<float>& values) {
  return Eigen::Map<const Eigen::VectorXf>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std_msgs::Header HeaderOf(const core::Episode& episode) {
  std_msgs::Header header;
  header.stamp = ToTime(episode.start);
  header.frame_id = episode.frame_id;
  return header;
}

}  // namespace

core::Nanoseconds ToNanoseconds(const ros::Time& time) { return static_cast<core::Nanoseconds>(time.toNSec()); }

ros::Time ToTime(core::Nanoseconds nanoseconds) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(std::max<core::Nanoseconds>(0, nanoseconds)));
  return time;
}

core::Nanoseconds WallNow() { return static_cast<core::Nanoseconds>(ros::WallTime::now().toNSec()); }

Eigen::Vector3d ToVector(const geometry_msgs::Vector3& vector) { return {vector.x, vector.y, vector.z}; }

core::Episode FromMessage(const Episode& message) {
  core::Episode episode;
  episode.id = message.episode_id;
  episode.frame_id = message.header.frame_id;
  episode.start = ToNanoseconds(message.header.stamp);
  episode.sample_period = message.sample_period;
  episode.force = FromList(message.force);
  episode.complete = message.complete;
  episode.end_reason = static_cast<core::EndReason>(message.end_reason);
  episode.outcome = message.outcome;
  if (!core::IsSamplePeriod(episode.sample_period)) {
    throw std::invalid_argument("episode " + episode.id + " has a sample period that is not in [0.0001, 1] s");
  }
  if (!episode.force.allFinite()) {
    throw std::invalid_argument("episode " + episode.id + " holds a force that is not finite");
  }
  // The tare may double the greatest force.
  if ((episode.force.array().abs() > static_cast<float>(2.0 * core::kGreatestForce)).any()) {
    throw std::invalid_argument("episode " + episode.id + " holds a force above 2e6 N, which no sensor measures");
  }
  return episode;
}

Episode ToMessage(const core::Episode& episode) {
  Episode message;
  message.header = HeaderOf(episode);
  message.episode_id = episode.id;
  message.sample_period = episode.sample_period;
  message.force = ToList(episode.force);
  message.complete = episode.complete;
  message.end_reason = static_cast<std::uint8_t>(episode.end_reason);
  message.outcome = episode.outcome;
  return message;
}

EpisodeEvent ToMessage(const core::EpisodeEdge& edge, const std::string& frame_id) {
  EpisodeEvent message;
  message.header.stamp = ToTime(edge.time);
  message.header.frame_id = frame_id;
  message.kind = edge.open ? EpisodeEvent::OPEN : EpisodeEvent::CLOSE;
  message.episode_id = edge.id;
  return message;
}

Tare TareMessage(const Eigen::Vector3d& force, core::Nanoseconds time, const std::string& frame_id) {
  Tare message;
  message.header.stamp = ToTime(time);
  message.header.frame_id = frame_id;
  message.force.x = force.x();
  message.force.y = force.y();
  message.force.z = force.z();
  return message;
}

core::Model FromMessage(const ShapeletModel& message) {
  if (message.format_version != ShapeletModel::FORMAT_VERSION) {
    throw std::invalid_argument("the model has format version " + std::to_string(message.format_version) +
                                ", expected " + std::to_string(ShapeletModel::FORMAT_VERSION));
  }
  if (message.cluster_labels.size() != message.centroids.size()) {
    throw std::invalid_argument("the model has " + std::to_string(message.centroids.size()) + " clusters, but " +
                                std::to_string(message.cluster_labels.size()) + " labels");
  }
  core::Model model;
  model.id = message.model_id;
  model.sample_period = message.sample_period;
  model.flat_fraction = message.flat_fraction;
  model.log_offset = message.log_offset;
  for (const Shapelet& shapelet : message.shapelets) {
    model.shapelets.push_back(
        {static_cast<int>(shapelet.scale), static_cast<int>(shapelet.dilation), FromList(shapelet.values)});
  }
  for (std::size_t index = 0; index < message.centroids.size(); ++index) {
    const Centroid& centroid = message.centroids[index];
    model.clusters.push_back({FromList(centroid.values), centroid.novelty_limit, static_cast<int>(centroid.size),
                              message.cluster_labels[index]});
  }
  model.provenance = {message.sources,
                      message.objective,
                      message.selected_scales,
                      message.seed,
                      static_cast<int>(message.training_episodes),
                      message.typical_duration,
                      ToNanoseconds(message.header.stamp)};
  model.preparation = FromMessage(message.preparation);
  const std::string faults = model.Faults();
  if (!faults.empty()) throw std::invalid_argument("the model cannot be used: " + faults);
  return model;
}

ShapeletModel ToMessage(const core::Model& model) {
  ShapeletModel message;
  message.header.stamp = ToTime(model.provenance.trained);
  message.model_id = model.id;
  message.format_version = ShapeletModel::FORMAT_VERSION;
  message.sample_period = model.sample_period;
  message.flat_fraction = model.flat_fraction;
  message.log_offset = model.log_offset;
  for (const core::Shapelet& shapelet : model.shapelets) {
    Shapelet entry;
    entry.scale = static_cast<std::uint32_t>(shapelet.scale);
    entry.dilation = static_cast<std::uint32_t>(shapelet.dilation);
    entry.values = ToList(shapelet.values);
    message.shapelets.push_back(entry);
  }
  for (const core::Cluster& cluster : model.clusters) {
    Centroid entry;
    entry.values = ToList(cluster.centroid);
    entry.novelty_limit = cluster.novelty_limit;
    entry.size = static_cast<std::uint32_t>(cluster.size);
    message.centroids.push_back(entry);
    message.cluster_labels.push_back(cluster.label);
  }
  message.sources = model.provenance.sources;
  message.objective = model.provenance.objective;
  message.selected_scales = model.provenance.selected_scales;
  message.seed = model.provenance.seed;
  message.training_episodes = static_cast<std::uint32_t>(model.provenance.training_episodes);
  message.typical_duration = model.provenance.typical_duration;
  message.preparation = ToMessage(model.preparation);
  return message;
}

ShapeletFeatures FeaturesMessage(const core::Episode& episode, const core::Model& model,
                                 const core::ShapeletDistances& features) {
  ShapeletFeatures message;
  message.header = HeaderOf(episode);
  message.episode_id = episode.id;
  message.model_id = model.id;
  message.distances = ToList(features.distances);
  message.memberships = ToList(features.memberships);
  for (Eigen::Index k = 0; k < features.match_start.size(); ++k) {
    const bool matched = features.match_start[k] >= 0;
    const double start = matched ? features.match_start[k] * model.sample_period : std::nan("");
    message.match_time.push_back(static_cast<float>(start));
    message.match_duration.push_back(static_cast<float>(features.match_span[k] * model.sample_period));
  }
  return message;
}

Diagnosis DiagnosisMessage(const core::Episode& episode, const core::Model& model, const core::Diagnosis& diagnosis,
                           bool final) {
  Diagnosis message;
  message.header = HeaderOf(episode);
  message.episode_id = episode.id;
  message.model_id = model.id;
  message.cluster = diagnosis.cluster;
  message.event = diagnosis.event;
  message.confidence = diagnosis.confidence;
  message.novelty = diagnosis.novelty;
  message.final = final;
  return message;
}

}  // namespace contact_shapelets
