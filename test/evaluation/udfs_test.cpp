#include "evaluation/udfs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/numerics/random.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns `count` points of 3 groups. The `planted` features tell groups apart; the others are noise of equal
/// variance.
Eigen::MatrixXd PlantedPoints(int count, int features, const std::vector<int>& planted, std::uint64_t seed) {
  core::Random random(seed);
  Eigen::MatrixXd points(count, features);
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < features; ++column) points(row, column) = random.Normal();
    for (std::size_t index = 0; index < planted.size(); ++index) {
      const double level = (row % 3 == static_cast<int>(index % 3)) ? 1.4 : -0.7;
      points(row, planted[index]) = level + 0.1 * random.Normal();
    }
  }
  return points;
}

TEST(SelectFeatures, FindsThePlantedDiscriminativeFeatures) {
  const std::vector<int> planted{3, 7, 12, 18};
  const Eigen::VectorXd weights = SelectFeatures(PlantedPoints(90, 20, planted, 1), 3, UdfsOptions{}).weights;
  double least_planted = 1.0;
  double most_noise = 0.0;
  for (int column = 0; column < 20; ++column) {
    const bool is_planted = std::find(planted.begin(), planted.end(), column) != planted.end();
    if (is_planted) least_planted = std::min(least_planted, weights[column]);
    if (!is_planted) most_noise = std::max(most_noise, weights[column]);
  }
  EXPECT_GT(least_planted, most_noise);
}

TEST(SelectFeatures, NeverRaisesItsObjective) {
  UdfsOptions options;
  options.sparsity = 5.0;
  const std::vector<double> objectives = SelectFeatures(PlantedPoints(60, 15, {2, 9}, 2), 3, options).objectives;
  ASSERT_GE(objectives.size(), 3U);
  for (std::size_t round = 1; round < objectives.size(); ++round) {
    EXPECT_LE(objectives[round], objectives[round - 1] * (1.0 + 1e-9)) << "round " << round;
  }
}

TEST(SelectFeatures, MatchesACaseDoneByHand) {
  // Two points with one neighbour: both centred neighbourhoods are (-1, 1) along the first feature and 0 along the
  // second. So X H B H X^T is 2 * 1 / (2 + lambda) along the first, M = diag(4 / 3, 0) for lambda = 1, and W is the
  // second axis.
  Eigen::MatrixXd points(2, 2);
  points << 0.0, 5.0, 2.0, 5.0;
  UdfsOptions options;
  options.neighbours = 1;
  options.ridge = 1.0;
  options.sparsity = 0.5;
  const UdfsResult result = SelectFeatures(points, 1, options);
  EXPECT_NEAR(result.weights[0], 0.0, 1e-9);
  EXPECT_NEAR(result.weights[1], 1.0, 1e-9);
  EXPECT_NEAR(result.objectives.back(), 0.5, 1e-9);
  // With as many clusters as features, W is a whole basis, and tr(W^T M W) is the trace of M.
  EXPECT_NEAR(SelectFeatures(points, 2, options).objectives.front(), 4.0 / 3.0 + 0.5 * 2.0, 1e-9);
}

TEST(SelectFeatures, TakesAllOtherPointsIfThereAreFewerThanNeighbours) {
  UdfsOptions many;
  many.neighbours = 50;
  UdfsOptions exact;
  exact.neighbours = 5;
  const Eigen::MatrixXd points = PlantedPoints(6, 8, {1, 4}, 3);
  EXPECT_EQ(SelectFeatures(points, 2, many).weights, SelectFeatures(points, 2, exact).weights);
}

TEST(SelectFeatures, RefusesInvalidInput) {
  const Eigen::MatrixXd points = PlantedPoints(6, 3, {1}, 4);
  EXPECT_THROW(SelectFeatures(points.topRows(1), 2, UdfsOptions{}), std::invalid_argument);
  EXPECT_THROW(SelectFeatures(points, 4, UdfsOptions{}), std::invalid_argument);
  UdfsOptions options;
  options.ridge = 0.0;
  EXPECT_THROW(SelectFeatures(points, 2, options), std::invalid_argument);
}

TEST(UdfsClusterer, KeepsTheWantedPartOfTheSamples) {
  UdfsOptions options;
  options.kept_part = 0.2;
  UdfsClusterer clusterer(options);
  std::vector<Eigen::VectorXf> series;
  const Eigen::MatrixXd points = PlantedPoints(30, 20, {3, 7, 12, 18}, 5);
  for (Eigen::Index row = 0; row < points.rows(); ++row) series.push_back(points.row(row).transpose().cast<float>());
  clusterer.Fit(series, 3, 0);
  EXPECT_EQ(clusterer.kept(), (std::vector<int>{3, 7, 12, 18}));
  EXPECT_EQ(clusterer.Transform(series).cols(), 4);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
