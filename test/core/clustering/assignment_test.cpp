#include "core/clustering/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

double LeastCostByTrying(const Eigen::MatrixXd& cost) {
  const bool wide = cost.rows() <= cost.cols();
  const Eigen::MatrixXd flat = wide ? cost : Eigen::MatrixXd(cost.transpose());
  std::vector<int> order(static_cast<std::size_t>(flat.cols()));
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (Eigen::Index row = 0; row < flat.rows(); ++row) sum += flat(row, order[static_cast<std::size_t>(row)]);
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

class AssignmentTest : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(AssignmentTest, CostsAsLittleAsTheBestOfAllPermutations) {
  Random random(4);
  const auto [rows, columns] = GetParam();
  for (int round = 0; round < 30; ++round) {
    Eigen::MatrixXd cost(rows, columns);
    // Small whole numbers of either sign give ties.
    for (Eigen::Index entry = 0; entry < cost.size(); ++entry) cost.data()[entry] = random.Index(12) - 6;
    const std::vector<int> assigned = LeastCostAssignment(cost);
    ASSERT_EQ(assigned.size(), static_cast<std::size_t>(rows));
    std::vector<bool> taken(static_cast<std::size_t>(columns), false);
    double sum = 0.0;
    int left_over = 0;
    for (int row = 0; row < rows; ++row) {
      const int column = assigned[static_cast<std::size_t>(row)];
      if (column < 0) {
        ++left_over;
        continue;
      }
      EXPECT_FALSE(taken.at(static_cast<std::size_t>(column)));
      taken[static_cast<std::size_t>(column)] = true;
      sum += cost(row, column);
    }
    EXPECT_EQ(left_over, std::max(0, rows - columns));
    EXPECT_NEAR(sum, LeastCostByTrying(cost), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, AssignmentTest,
                         testing::Values(std::pair(1, 1), std::pair(2, 2), std::pair(4, 4), std::pair(6, 6),
                                         std::pair(2, 5), std::pair(6, 3), std::pair(5, 1), std::pair(1, 5)));

TEST(LeastCostAssignment, LeavesEveryRowOverIfThereIsNoColumn) {
  EXPECT_EQ(LeastCostAssignment(Eigen::MatrixXd(3, 0)), (std::vector<int>{-1, -1, -1}));
  EXPECT_TRUE(LeastCostAssignment(Eigen::MatrixXd(0, 3)).empty());
}

TEST(LeastCostAssignment, RefusesACostThatIsNotFinite) {
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(2, 2);
  cost(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LeastCostAssignment(cost), std::invalid_argument);
  cost(1, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(LeastCostAssignment(cost), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
