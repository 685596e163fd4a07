#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// The best one-to-one assignment between two sets.

namespace contact_shapelets::core {

/// The assignment of rows to columns of `cost` [R, C] with the least sum (Hungarian method; Kuhn 1955, Munkres 1957).
/// Returns for each row its column, -1 for rows left over where R > C.
/// \throws std::invalid_argument where a cost is not finite.
std::vector<int> LeastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost);

}  // namespace contact_shapelets::core
