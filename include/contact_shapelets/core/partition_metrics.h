#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

/// \file
/// How well two partitions of the same items agree, and the names that this gives to clusters.

namespace contact_shapelets::core {

/// Agreement of a partition with the true classes.
struct PartitionScores {
  double rand_index = 0.0;                     ///< [0, 1] part of the pairs that are grouped alike
  double adjusted_rand_index = 0.0;            ///< 1 at best, 0 expected by chance
  double normalised_mutual_information = 0.0;  ///< [0, 1], by the arithmetic mean of the entropies
  double accuracy = 0.0;                       ///< [0, 1] under the best assignment of clusters to classes
};

/// Compares `labels` with `classes`, both [N] with values of 0 or more.
/// Partitions of fewer than two items agree wholly.
/// \throws std::invalid_argument where sizes differ or a label is negative.
PartitionScores ComparePartitions(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                  const Eigen::Ref<const Eigen::VectorXi>& classes);

/// Agreement with the outcomes of those episodes that have one.
struct OutcomeScores {
  std::size_t episodes = 0;  ///< with an outcome
  PartitionScores scores;
};

/// How `labels` [N] agree with the outcomes of `episodes` [N]; nothing where fewer than two of them have one.
/// \throws std::invalid_argument where sizes differ or a label is negative.
std::optional<OutcomeScores> CompareWithOutcomes(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                                 const std::vector<Episode>& episodes);

/// The assignment of rows to columns of `cost` [R, C] with the least sum (Hungarian method; Kuhn 1955, Munkres 1957).
/// Returns for each row its column, -1 for rows left over where R > C.
/// \throws std::invalid_argument where a cost is not finite.
std::vector<int> LeastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost);

/// Names for `clusters` clusters from the outcomes that were given for some items.
///
/// `labels` [N] are the items' clusters, `outcomes` [N] what was said of each, empty where nothing was. Each outcome is
/// assigned to at most one cluster, so that the number of items named right is largest, and names it unless another
/// outcome has more than twice as many items there: a rare outcome must not name a cluster that hardly holds it.
/// Clusters that are left over take the outcome of most of their items, where more than half of the named ones agree,
/// and stay unnamed (empty string) elsewhere. \throws std::invalid_argument where sizes differ or a label is out of
/// range.
std::vector<std::string> NameClusters(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                      const std::vector<std::string>& outcomes, int clusters);

}  // namespace contact_shapelets::core
