#include "core/model/cluster_names.h"

#include <algorithm>
#include <stdexcept>

#include "core/clustering/assignment.h"

namespace contact_shapelets::core {

std::vector<std::string> NameClusters(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                      const std::vector<std::string>& outcomes, int clusters) {
  if (static_cast<std::size_t>(labels.size()) != outcomes.size()) {
    throw std::invalid_argument("there must be one outcome (empty or not) for each label");
  }
  if ((labels.array() < 0 || labels.array() >= clusters).any()) throw std::invalid_argument("a label is out of range");
  std::vector<std::string> names;
  for (const std::string& outcome : outcomes) {
    if (!outcome.empty() && std::find(names.begin(), names.end(), outcome) == names.end()) names.push_back(outcome);
  }
  std::vector<std::string> named(static_cast<std::size_t>(clusters));
  if (names.empty()) return named;
  std::sort(names.begin(), names.end());
  Eigen::MatrixXd table = Eigen::MatrixXd::Zero(clusters, static_cast<Eigen::Index>(names.size()));
  for (Eigen::Index item = 0; item < labels.size(); ++item) {
    const std::string& outcome = outcomes[static_cast<std::size_t>(item)];
    if (outcome.empty()) continue;
    table(labels[item], std::lower_bound(names.begin(), names.end(), outcome) - names.begin()) += 1.0;
  }
  const std::vector<int> assigned = LeastCostAssignment(-table);
  for (int cluster = 0; cluster < clusters; ++cluster) {
    const int column = assigned[static_cast<std::size_t>(cluster)];
    Eigen::Index most = 0;
    const double items = table.row(cluster).maxCoeff(&most);
    std::string& name = named[static_cast<std::size_t>(cluster)];
    if (column >= 0 && items > 0.0 && 2.0 * table(cluster, column) >= items) {
      name = names[static_cast<std::size_t>(column)];
    } else if (2.0 * items > table.row(cluster).sum()) {
      name = names[static_cast<std::size_t>(most)];
    }
  }
  return named;
}

}  // namespace contact_shapelets::core
