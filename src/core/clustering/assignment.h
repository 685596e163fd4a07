#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// The best one-to-one assignment between two sets.

namespace contact_shapelets::core {

/// Assigns rows to columns of `cost` [R, C] so that the sum is least (Hungarian method; Kuhn 1955, Munkres 1957).
/// Returns the column of each row. If R > C, the R - C rows left over get -1.
/// \throws std::invalid_argument if a cost is not finite.
std::vector<int> LeastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost);

}  // namespace contact_shapelets::core
