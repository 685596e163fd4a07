#include "evaluation/partition_metrics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/clustering/assignment.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns the number of items in each cluster (rows) and class (columns).
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
  scores.accuracy = AssignedItems(table, core::LeastCostAssignment(-table)) / count;
  return scores;
}

std::optional<OutcomeScores> CompareWithOutcomes(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                                 const std::vector<core::Episode>& episodes) {
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

}  // namespace contact_shapelets::evaluation
