#include "contact_shapelets/core/partition_metrics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

/// Number of items in each cluster (rows) and class (columns).
Eigen::MatrixXd Contingency(const Eigen::Ref<const Eigen::VectorXi>& labels,
                            const Eigen::Ref<const Eigen::VectorXi>& classes) {
  Eigen::MatrixXd table = Eigen::MatrixXd::Zero(labels.maxCoeff() + 1, classes.maxCoeff() + 1);
  for (Eigen::Index item = 0; item < labels.size(); ++item) table(labels[item], classes[item]) += 1.0;
  return table;
}

double Pairs(const Eigen::Ref<const Eigen::ArrayXXd>& counts) { return (counts * (counts - 1.0) / 2.0).sum(); }

double Entropy(const Eigen::Ref<const Eigen::ArrayXXd>& parts) {
  return -(parts > 0.0).select(parts * parts.max(1e-300).log(), 0.0).sum();
}

void ScorePairs(const Eigen::MatrixXd& table, double count, PartitionScores* scores) {
  const double together = Pairs(table.array());
  const double in_clusters = Pairs(table.rowwise().sum().array());
  const double in_classes = Pairs(table.colwise().sum().array());
  const double all = count * (count - 1.0) / 2.0;
  scores->rand_index = (all + 2.0 * together - in_clusters - in_classes) / all;
  const double expected = in_clusters * in_classes / all;
  const double most = 0.5 * (in_clusters + in_classes);
  scores->adjusted_rand_index = most == expected ? 1.0 : (together - expected) / (most - expected);
}

double NormalisedMutualInformation(const Eigen::MatrixXd& table, double count) {
  const Eigen::ArrayXXd joint = table.array() / count;
  const double clusters = Entropy(joint.rowwise().sum());
  const double classes = Entropy(joint.colwise().sum());
  const double mean = 0.5 * (clusters + classes);
  return mean <= 0.0 ? 1.0 : std::max(0.0, (clusters + classes - Entropy(joint)) / mean);
}

double AssignedItems(const Eigen::MatrixXd& table, const std::vector<int>& assigned) {
  double items = 0.0;
  for (std::size_t row = 0; row < assigned.size(); ++row) {
    if (assigned[row] >= 0) items += table(static_cast<Eigen::Index>(row), assigned[row]);
  }
  return items;
}

}  // namespace

PartitionScores ComparePartitions(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                  const Eigen::Ref<const Eigen::VectorXi>& classes) {
  if (labels.size() != classes.size()) throw std::invalid_argument("partitions of different sizes cannot be compared");
  if ((labels.array() < 0).any() || (classes.array() < 0).any()) throw std::invalid_argument("a label is negative");
  if (labels.size() < 2) return {1.0, 1.0, 1.0, 1.0};
  const Eigen::MatrixXd table = Contingency(labels, classes);
  const auto count = static_cast<double>(labels.size());
  PartitionScores scores;
  ScorePairs(table, count, &scores);
  scores.normalised_mutual_information = NormalisedMutualInformation(table, count);
  scores.accuracy = AssignedItems(table, LeastCostAssignment(-table)) / count;
  return scores;
}

std::optional<OutcomeScores> CompareWithOutcomes(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                                 const std::vector<Episode>& episodes) {
  if (static_cast<std::size_t>(labels.size()) != episodes.size()) {
    throw std::invalid_argument("there must be one label for each episode");
  }
  std::map<std::string, int> numbers;
  Eigen::VectorXi used(labels.size());
  Eigen::VectorXi classes(labels.size());
  Eigen::Index count = 0;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const std::string& outcome = episodes[index].outcome;
    if (outcome.empty()) continue;
    used[count] = labels[static_cast<Eigen::Index>(index)];
    classes[count] = numbers.emplace(outcome, static_cast<int>(numbers.size())).first->second;
    ++count;
  }
  if (count < 2) return std::nullopt;
  return OutcomeScores{static_cast<std::size_t>(count), ComparePartitions(used.head(count), classes.head(count))};
}

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
