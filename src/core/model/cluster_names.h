#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// \file
/// Names of clusters by the outcomes that operators gave.

namespace contact_shapelets::core {

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
