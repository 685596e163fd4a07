// UDFS, against values computed by NumPy.
#include <gtest/gtest.h>

#include "evaluation/udfs.h"
#include "golden/golden_values.h"

namespace contact_shapelets::evaluation {
namespace {

TEST(GoldenUdfs, HasTheseObjectivesAndWeights) {
  const Eigen::MatrixXd objectives = test::Golden("udfs.objectives");
  UdfsOptions options;
  options.neighbours = static_cast<int>(test::GoldenNumber("udfs.neighbours"));
  options.ridge = test::GoldenNumber("udfs.ridge");
  options.sparsity = test::GoldenNumber("udfs.sparsity");
  options.iterations = static_cast<int>(objectives.cols());
  const UdfsResult result =
      SelectFeatures(test::Golden("udfs.points"), static_cast<int>(test::GoldenNumber("udfs.clusters")), options);
  ASSERT_EQ(static_cast<Eigen::Index>(result.objectives.size()), objectives.cols());
  for (std::size_t round = 0; round < result.objectives.size(); ++round) {
    EXPECT_NEAR(result.objectives[round], objectives(0, static_cast<Eigen::Index>(round)), 1e-9) << "round " << round;
  }
  EXPECT_LT(test::LargestDifference(result.weights.transpose(), test::Golden("udfs.weights")), 1e-9);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
