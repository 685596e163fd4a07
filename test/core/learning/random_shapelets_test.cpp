#include "core/learning/random_shapelets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

std::vector<Eigen::VectorXf> Walks(int count, int length, std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::VectorXf> series;
  for (int index = 0; index < count; ++index) {
    Eigen::VectorXf walk(length);
    float value = 0.0F;
    for (int sample = 0; sample < length; ++sample) walk[sample] = value += static_cast<float>(random.Normal());
    series.push_back(walk);
  }
  return series;
}

TEST(RandomShapelets, AreFoundWithoutDistanceInTheSeriesThatTheyWereDrawnFrom) {
  const std::vector<Eigen::VectorXf> series = Walks(1, 120, 1);
  const Eigen::MatrixXf distances = RandomShapelets(series, 50, 2).Distances(series, 1);
  ASSERT_EQ(distances.cols(), 50);
  EXPECT_LT(distances.maxCoeff(), 2e-3F);
}

TEST(RandomShapelets, DistancesStayWithinTheirRangeOnOtherSeries) {
  const RandomShapelets shapelets(Walks(5, 120, 3), 50, 4);
  const Eigen::MatrixXf distances = shapelets.Distances(Walks(20, 90, 5), 1);
  EXPECT_GT(distances.minCoeff(), 0.0F);
  EXPECT_LE(distances.maxCoeff(), std::sqrt(2.0F));
}

TEST(RandomShapelets, SeeAPatternAtAnyOffsetAndAmplitude) {
  const std::vector<Eigen::VectorXf> series = Walks(4, 100, 6);
  std::vector<Eigen::VectorXf> changed;
  for (const Eigen::VectorXf& one : series) changed.emplace_back(40.0F + 3.0F * one.array());
  const RandomShapelets shapelets(series, 40, 7);
  EXPECT_LT((shapelets.Distances(series, 1) - shapelets.Distances(changed, 1)).cwiseAbs().maxCoeff(), 2e-3F);
}

TEST(RandomShapelets, DoNotDependOnTheNumberOfThreads) {
  const std::vector<Eigen::VectorXf> series = Walks(9, 80, 8);
  const RandomShapelets shapelets(series, 30, 9);
  EXPECT_EQ(shapelets.Distances(series, 1), shapelets.Distances(series, 3));
}

TEST(RandomShapelets, AreTheSameForASeedAndOthersForAnother) {
  const std::vector<Eigen::VectorXf> series = Walks(9, 80, 10);
  const Eigen::MatrixXf distances = RandomShapelets(series, 30, 11).Distances(series, 1);
  EXPECT_EQ(distances, RandomShapelets(series, 30, 11).Distances(series, 1));
  EXPECT_NE(distances, RandomShapelets(series, 30, 12).Distances(series, 1));
}

TEST(RandomShapelets, CorrelateWithNothingInAFlatSeries) {
  const RandomShapelets shapelets(Walks(3, 60, 13), 10, 14);
  const Eigen::MatrixXf distances = shapelets.Distances({Eigen::VectorXf::Constant(60, 7.0F)}, 1);
  EXPECT_TRUE(distances.isOnes());
}

TEST(RandomShapelets, AcceptSeriesShorterThanAShapelet) {
  const RandomShapelets shapelets(Walks(3, 200, 15), 40, 16);
  EXPECT_TRUE(shapelets.Distances(Walks(2, 2, 17), 1).allFinite());
  EXPECT_TRUE(RandomShapelets(Walks(3, 2, 18), 5, 19).Distances(Walks(2, 4, 20), 1).allFinite());
}

TEST(RandomShapelets, ReachFromTheirLengthToThatOfTheSeries) {
  const std::vector<Eigen::VectorXf> series(5, Eigen::VectorXf::LinSpaced(200, 0.0F, 1.0F));
  const Eigen::VectorXf reaches = RandomShapelets(series, 300, 1).Reaches();
  EXPECT_EQ(reaches.size(), 300);
  EXPECT_EQ(reaches.minCoeff(), static_cast<float>(RandomShapelets::kLength));
  EXPECT_LE(reaches.maxCoeff(), 200.0F);
  EXPECT_GT(reaches.maxCoeff(), 150.0F);
}

TEST(RandomShapelets, NeedASeriesOfTwoValues) {
  EXPECT_THROW(RandomShapelets({}, 5, 0), std::invalid_argument);
  EXPECT_THROW(RandomShapelets({Eigen::VectorXf::Ones(1)}, 5, 0), std::invalid_argument);
}

TEST(Standardised, HasMeanZeroAndDeviationOneInEachColumn) {
  Eigen::MatrixXf features(4, 2);
  features << 1, 10, 2, 10, 3, 10, 4, 10;
  const Eigen::MatrixXf standardised = Standardised(features);
  EXPECT_NEAR(standardised.col(0).mean(), 0.0F, 1e-6F);
  EXPECT_NEAR(standardised.col(0).squaredNorm() / 4.0F, 1.0F, 1e-5F);
  EXPECT_TRUE(standardised.col(1).isZero());
}

}  // namespace
}  // namespace contact_shapelets::core
