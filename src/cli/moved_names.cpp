#include "cli/moved_names.h"

#include <algorithm>
#include <set>

#include "cli/episode_table.h"
#include "contact_shapelets/core/classifier.h"
#include "core/model/cluster_names.h"

namespace contact_shapelets::cli {

std::vector<std::string> MoveNames(const core::Model& old, const std::vector<core::Episode>& episodes,
                                   const Eigen::Ref<const Eigen::VectorXi>& labels, int threads, core::Model* model) {
  std::set<std::string> old_names;
  for (const core::Cluster& cluster : old.clusters) old_names.insert(cluster.label);
  old_names.erase("");
  std::vector<std::string> events;
  for (const core::Classification& result : ClassifyAll(core::Classifier(old), episodes, threads)) {
    events.push_back(result.diagnosis.event);
  }
  const std::vector<std::string> names = core::NameClusters(labels, events, static_cast<int>(model->clusters.size()));
  std::vector<std::string> lines;
  std::set<std::string> kept;
  for (std::size_t index = 0; index < names.size(); ++index) {
    std::string& label = model->clusters[index].label;
    if (label.empty() && old_names.count(names[index]) > 0) {
      label = names[index];
      lines.push_back("cluster " + std::to_string(index) + " takes the name " + label + " of the old model");
    }
    kept.insert(label);
  }
  for (const std::string& name : old_names) {
    if (kept.count(name) == 0) {
      lines.push_back("the name " + name + " of the old model did not move: no cluster without a name is mostly " +
                      name);
    }
  }
  return lines;
}

}  // namespace contact_shapelets::cli
