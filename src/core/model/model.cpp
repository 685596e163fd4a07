#include "contact_shapelets/core/model.h"

#include <sstream>

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets::core {
namespace {

void CheckShapelets(const Model& model, std::ostream& faults) {
  if (model.shapelets.empty()) faults << "the model has no shapelet\n";
  for (std::size_t index = 0; index < model.shapelets.size(); ++index) {
    const Shapelet& shapelet = model.shapelets[index];
    if (shapelet.values.size() < 2) faults << "shapelet " << index << " has fewer than 2 values\n";
    if (!shapelet.values.allFinite()) faults << "shapelet " << index << " holds a value that is not finite\n";
    if (shapelet.dilation < 1) faults << "shapelet " << index << " has a dilation below 1\n";
  }
}

void CheckClusters(const Model& model, std::ostream& faults) {
  if (model.clusters.empty()) faults << "the model has no cluster\n";
  for (std::size_t index = 0; index < model.clusters.size(); ++index) {
    const Cluster& cluster = model.clusters[index];
    if (cluster.centroid.size() != static_cast<Eigen::Index>(model.shapelets.size())) {
      faults << "cluster " << index << " has " << cluster.centroid.size() << " features, but there are "
             << model.shapelets.size() << " shapelets\n";
    }
    if (!cluster.centroid.allFinite()) faults << "cluster " << index << " holds a value that is not finite\n";
    if (!(cluster.novelty_limit > 0.0F)) faults << "cluster " << index << " has a novelty limit that is not above 0\n";
  }
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
  if (!IsSamplePeriod(sample_period)) faults << "the sample period is not in [0.0001, 1] s\n";
  if (!(flat_fraction >= 0.0 && flat_fraction < 1.0)) faults << "the flat fraction is not in [0, 1)\n";
  if (!(log_offset >= 0.0 && log_offset <= 1.0)) faults << "the log offset is not in [0, 1]\n";
  CheckShapelets(*this, faults);
  CheckClusters(*this, faults);
  return faults.str();
}

}  // namespace contact_shapelets::core
