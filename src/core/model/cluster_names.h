#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// \file
/// Names clusters by the outcomes that operators reported.

namespace contact_shapelets::core {

/// Returns a name for each of `clusters` clusters, by the outcomes of some items.
///
/// `labels` [N] are the clusters of the items, `outcomes` [N] their outcomes, empty if unknown. The assignment gives
/// each outcome at most one cluster and maximises the number of items with the right name. An outcome does not name its
/// cluster if another outcome has more than twice as many items there, so a rare outcome cannot name a cluster that
/// hardly holds it. Each other cluster takes the outcome of more than half of its items that have one, else it has no
/// name (an empty string). \throws std::invalid_argument if sizes differ or a label is out of range.
std::vector<std::string> NameClusters(const Eigen::Ref<const Eigen::VectorXi>& labels,
                                      const std::vector<std::string>& outcomes, int clusters);

}  // namespace contact_shapelets::core
