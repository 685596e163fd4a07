#include "core/clustering/assignment.h"

#include <limits>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

/// Shortest augmenting paths with potentials, for R <= C: the Hungarian method in O(R^2 C).
std::vector<int> AssignRows(const Eigen::MatrixXd& cost) {
  const auto rows = static_cast<int>(cost.rows());
  const auto columns = static_cast<int>(cost.cols());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // Row and column 0 stand for "none". Paths start there.
  std::vector<double> row_potential(rows + 1, 0.0);
  std::vector<double> column_potential(columns + 1, 0.0);
  std::vector<int> row_of(columns + 1, 0);
  for (int row = 1; row <= rows; ++row) {
    std::vector<double> slack(columns + 1, kInfinity);
    std::vector<int> before(columns + 1, 0);
    std::vector<bool> visited(columns + 1, false);
    row_of[0] = row;
    int column = 0;
    do {
      visited[column] = true;
      int next = 0;
      double least = kInfinity;
      for (int other = 1; other <= columns; ++other) {
        if (visited[other]) continue;
        const int at = row_of[column];
        const double reduced = cost(at - 1, other - 1) - row_potential[at] - column_potential[other];
        if (reduced < slack[other]) {
          slack[other] = reduced;
          before[other] = column;
        }
        if (slack[other] < least) {
          least = slack[other];
          next = other;
        }
      }
      for (int other = 0; other <= columns; ++other) {
        if (visited[other]) {
          row_potential[row_of[other]] += least;
          column_potential[other] -= least;
        } else {
          slack[other] -= least;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    for (; column != 0; column = before[column]) row_of[column] = row_of[before[column]];
  }
  std::vector<int> assigned(rows, -1);
  for (int column = 1; column <= columns; ++column) {
    if (row_of[column] > 0) assigned[row_of[column] - 1] = column - 1;
  }
  return assigned;
}

}  // namespace

std::vector<int> LeastCostAssignment(const Eigen::Ref<const Eigen::MatrixXd>& cost) {
  if (!cost.allFinite()) throw std::invalid_argument("an assignment cost is not finite");
  if (cost.rows() <= cost.cols()) return AssignRows(cost);
  const std::vector<int> row_of_column = AssignRows(cost.transpose());
  std::vector<int> assigned(static_cast<std::size_t>(cost.rows()), -1);
  for (std::size_t column = 0; column < row_of_column.size(); ++column) {
    assigned[static_cast<std::size_t>(row_of_column[column])] = static_cast<int>(column);
  }
  return assigned;
}

}  // namespace contact_shapelets::core
