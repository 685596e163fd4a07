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
  double rand_index = 0.0;                     ///< [0, 1] part of the pairs that both group alike
  double adjusted_rand_index = 0.0;            ///< 1 at best, 0 expected by chance
  double normalised_mutual_information = 0.0;  ///< [0, 1], divided by the arithmetic mean of the entropies
  double accuracy = 0.0;                       ///< [0, 1] under the best assignment of clusters to classes
};

/// Compares `labels` with `classes`, both [N] with values of 0 or more. All scores are 1 for fewer than two items.
/// \throws std::invalid_argument if sizes differ or a label is negative.
PartitionScores ComparePartitions(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                  const Eigen::Ref<const Eigen::VectorXi>& classes);

/// Agreement of a partition with the outcomes of episodes.
struct OutcomeScores {
  std::size_t episodes = 0;  ///< number of episodes with an outcome
  PartitionScores scores;
};

/// Compares `labels` [N] with the outcomes of those of `episodes` [N] that have one; nothing if fewer than two have
/// one. \throws std::invalid_argument if sizes differ or a label is negative.
std::optional<OutcomeScores> CompareWithOutcomes(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                                 const std::vector<core::Episode>& episodes);

}  // namespace contact_shapelets::evaluation
