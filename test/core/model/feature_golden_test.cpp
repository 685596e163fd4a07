// Equations 2 to 4 as the classifier computes them, against values computed by NumPy.
#include <gtest/gtest.h>

#include "contact_shapelets/core/feature_extractor.h"
#include "golden/golden_values.h"

namespace contact_shapelets::core {
namespace {

std::vector<Shapelet> GoldenShapelets() {
  std::vector<Shapelet> shapelets;
  for (const Eigen::VectorXf& values : test::GoldenSeries("matching.shapelets")) {
    Shapelet shapelet;
    shapelet.values = values;
    shapelets.push_back(shapelet);
  }
  return shapelets;
}

TEST(GoldenFeatures, AreTheDistancesToEveryShapelet) {
  const FeatureExtractor extractor(GoldenShapelets(), 0.0);
  const Eigen::MatrixXf distances = extractor.Distances(test::GoldenSeries("matching.series"), 1);
  EXPECT_LT(test::LargestDifference(distances.cast<double>(), test::Golden("matching.distances")), 1e-6);
}

TEST(GoldenFeatures, LeaveOutFlatWindows) {
  const FeatureExtractor extractor(GoldenShapelets(), test::GoldenNumber("matching.flat_fraction"));
  const Eigen::MatrixXf distances = extractor.Distances(test::GoldenSeries("matching.series"), 1);
  EXPECT_LT(test::LargestDifference(distances.cast<double>(), test::Golden("matching.distances_without_flat_windows")),
            1e-6);
}

TEST(GoldenFeatures, HaveTheMembershipsOfEquation4) {
  const FeatureExtractor extractor(GoldenShapelets(), 0.0);
  const std::vector<Eigen::VectorXf> series = test::GoldenSeries("matching.series");
  const Eigen::MatrixXd golden = test::Golden("matching.memberships");
  for (std::size_t row = 0; row < series.size(); ++row) {
    const Eigen::VectorXf memberships = extractor.Compute(series[row]).memberships;
    EXPECT_LT(test::LargestDifference(memberships.transpose().cast<double>(), golden.row(static_cast<int>(row))), 1e-6);
  }
}

}  // namespace
}  // namespace contact_shapelets::core
