#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

/// \file
/// How well two partitions of the same items agree.

namespace contact_shapelets::evaluation {

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
                                                 const std::vector<core::Episode>& episodes);

}  // namespace contact_shapelets::evaluation
