// k-Shape's distance, against values computed by NumPy.
#include <gtest/gtest.h>

#include "evaluation/k_shape.h"
#include "golden/golden_values.h"

namespace contact_shapelets::evaluation {
namespace {

TEST(GoldenShapes, HaveTheseDistancesAndShifts) {
  const Eigen::MatrixXd series = test::Golden("shapes.series");
  const Eigen::MatrixXd distances = test::Golden("shapes.distances");
  const Eigen::MatrixXd shifts = test::Golden("shapes.shifts");
  for (Eigen::Index x = 0; x < series.rows(); ++x) {
    for (Eigen::Index y = 0; y < series.rows(); ++y) {
      const ShapeDistance found = CompareShapes(series.row(x).transpose(), series.row(y).transpose());
      EXPECT_NEAR(found.distance, distances(x, y), 1e-12) << x << ", " << y;
      EXPECT_EQ(found.shift, shifts(x, y)) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace contact_shapelets::evaluation
