#include "evaluation/k_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics/random.h"
#include "evaluation/partition_metrics.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns a series of 64 samples with a shape of 12 samples: 0 is a bump, 1 one period of a sine.
Eigen::VectorXd Shape(int kind, int start) {
  Eigen::VectorXd series = Eigen::VectorXd::Zero(64);
  for (int index = 0; index < 12; ++index) {
    const double phase = M_PI * (index + 0.5) / 12.0;
    series[start + index] = kind == 0 ? std::sin(phase) : std::sin(2.0 * phase);
  }
  return series;
}

Eigen::MatrixXd Shapes(int count, std::uint64_t seed) {
  core::Random random(seed);
  Eigen::MatrixXd shapes(count, 64);
  for (int row = 0; row < count; ++row) {
    shapes.row(row) = Shape(row % 2, 10 + random.Index(30)).transpose();
    for (int column = 0; column < 64; ++column) shapes(row, column) += 0.05 * random.Normal();
  }
  return shapes;
}

TEST(CompareShapes, MatchesTheSumOverAllShifts) {
  core::Random random(3);
  Eigen::VectorXd x(37);
  Eigen::VectorXd y(37);
  for (int index = 0; index < 37; ++index) {
    x[index] = random.Normal();
    y[index] = random.Normal();
  }
  double best = -2.0;
  for (int shift = -36; shift <= 36; ++shift) {
    best = std::max(best, x.dot(Shifted(y, shift)) / (x.norm() * y.norm()));
  }
  const ShapeDistance distance = CompareShapes(x, y);
  EXPECT_NEAR(distance.distance, 1.0 - best, 1e-12);
  EXPECT_NEAR(x.dot(Shifted(y, distance.shift)) / (x.norm() * y.norm()), best, 1e-12);
}

TEST(CompareShapes, IsZeroForTheSameShapeMovedAndScaled) {
  const ShapeDistance distance = CompareShapes(Shape(0, 30), 2.5 * Shape(0, 13));
  EXPECT_NEAR(distance.distance, 0.0, 1e-12);
  EXPECT_EQ(distance.shift, 17);
  EXPECT_EQ(CompareShapes(Shape(0, 13), Shape(0, 30)).shift, -17);
}

TEST(CompareShapes, MatchesACaseDoneByHand) {
  // The shifts 0, 1 and -1 of (1, 2) and (2, -1) give 0, 4 and -1 over 5.
  const ShapeDistance distance = CompareShapes(Eigen::Vector2d(1, 2), Eigen::Vector2d(2, -1));
  EXPECT_NEAR(distance.distance, 0.2, 1e-12);
  EXPECT_EQ(distance.shift, 1);
}

TEST(CompareShapes, GivesASeriesOfZerosTheDistanceOne) {
  EXPECT_EQ(CompareShapes(Eigen::VectorXd::Zero(8), Eigen::VectorXd::Ones(8)).distance, 1.0);
}

TEST(CompareShapes, RefusesDifferentLengths) {
  EXPECT_THROW(CompareShapes(Eigen::VectorXd::Zero(8), Eigen::VectorXd::Zero(7)), std::invalid_argument);
}

TEST(Shifted, MovesRightAndLeftAndFillsWithZeros) {
  EXPECT_EQ(Shifted(Eigen::Vector3d(1, 2, 3), 1), Eigen::Vector3d(0, 1, 2));
  EXPECT_EQ(Shifted(Eigen::Vector3d(1, 2, 3), -2), Eigen::Vector3d(3, 0, 0));
  EXPECT_EQ(Shifted(Eigen::Vector3d(1, 2, 3), 3), Eigen::Vector3d(0, 0, 0));
}

TEST(ExtractShape, OfOneMemberIsThatMemberZNormalised) {
  const Eigen::VectorXd shape = ExtractShape(Eigen::RowVector4d(1, 2, 3, 6), Eigen::Vector4d::Zero());
  EXPECT_TRUE(shape.isApprox(Eigen::Vector4d(-2, -1, 0, 3) / std::sqrt(14.0 / 4.0), 1e-9));
}

TEST(ExtractShape, AlignsItsMembersToTheReference) {
  Eigen::MatrixXd members(3, 64);
  members << Shape(1, 12).transpose(), Shape(1, 30).transpose(), Shape(1, 44).transpose();
  EXPECT_NEAR(CompareShapes(ExtractShape(members, Shape(1, 20)), Shape(1, 20)).distance, 0.0, 1e-9);
}

TEST(ExtractShape, IsTheSameByEitherGramMatrix) {
  // Each member twice gives the same leading direction, but more rows than columns.
  const Eigen::MatrixXd members = Shapes(40, 5);
  Eigen::MatrixXd twice(80, 64);
  twice << members, members;
  EXPECT_TRUE(ExtractShape(twice, Shape(0, 20)).isApprox(ExtractShape(members, Shape(0, 20)), 1e-6));
}

TEST(KShape, FindsShapesWhereverTheyAre) {
  KShapeOptions options;
  options.restarts = 5;
  const KShapeResult result = KShape(Shapes(30, 1), options);
  Eigen::VectorXi truth(30);
  for (int index = 0; index < 30; ++index) truth[index] = index % 2;
  EXPECT_EQ(ComparePartitions(result.labels, truth).rand_index, 1.0);
  EXPECT_EQ(ComparePartitions(NearestShapes(result.centroids, Shapes(30, 2)), truth).rand_index, 1.0);
}

TEST(KShape, GivesTheSamePartitionWhenEverySeriesIsMoved) {
  Eigen::MatrixXd shapes(20, 64);
  Eigen::MatrixXd moved(20, 64);
  for (int row = 0; row < 20; ++row) {
    shapes.row(row) = Shape(row % 2, 20 + row % 5).transpose();
    moved.row(row) = Shape(row % 2, 20 + row % 5 + (7 * row) % 13 - 6).transpose();
  }
  KShapeOptions options;
  options.seed = 4;
  const Eigen::VectorXi labels = KShape(shapes, options).labels;
  EXPECT_EQ(ComparePartitions(KShape(moved, options).labels, labels).rand_index, 1.0);
}

TEST(KShape, LeavesNoClusterEmpty) {
  // There are two shapes only, so three of five clusters would be left empty.
  Eigen::MatrixXd shapes(12, 64);
  for (int row = 0; row < 12; ++row) shapes.row(row) = Shape(row % 2, 20).transpose();
  KShapeOptions options;
  options.clusters = 5;
  options.restarts = 1;
  const Eigen::VectorXi labels = KShape(shapes, options).labels;
  for (int cluster = 0; cluster < 5; ++cluster) EXPECT_GT((labels.array() == cluster).count(), 0);
}

TEST(KShape, RefusesFewerSeriesThanClusters) {
  KShapeOptions options;
  options.clusters = 3;
  EXPECT_THROW(KShape(Shapes(2, 1), options), std::invalid_argument);
}

TEST(ExtractShape, FindsTheLeadingDirectionIfTheSumOfTheMembersIsALesserOne) {
  Eigen::MatrixXd members(3, 4);
  members << 3, -3, 0, 0, -3, 3, 0, 0, 0, 0, 1, -1;
  const Eigen::VectorXd shape = ExtractShape(members, Eigen::VectorXd::Zero(4));
  EXPECT_NEAR(std::abs(shape[0]), std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(shape[0] + shape[1], 0.0, 1e-6);
  EXPECT_NEAR(shape[2], 0.0, 1e-6);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
