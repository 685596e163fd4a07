#include "evaluation/dtw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/numerics/random.h"
#include "evaluation/partition_metrics.h"

namespace contact_shapelets::evaluation {
namespace {

Eigen::VectorXf Series(std::initializer_list<float> values) {
  Eigen::VectorXf series(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), series.data());
  return series;
}

/// A bump at `place` (kind 0) or a step at `place` (kind 1) in 60 samples, with a little noise.
Eigen::VectorXf Moved(int kind, int place, core::Random* random) {
  Eigen::VectorXf series(60);
  for (int sample = 0; sample < 60; ++sample) {
    const double phase = (sample - place) / 4.0;
    const double value = kind == 0 ? 3.0 * std::exp(-phase * phase) : (sample < place ? 0.0 : 3.0);
    series[sample] = static_cast<float>(value + 0.05 * random->Normal());
  }
  return series;
}

TEST(DtwDistance, OfSeriesThatDifferByAWarpWithinTheBandIsZero) {
  const Eigen::VectorXf x = Series({0, 0, 1, 2, 1, 0});
  const Eigen::VectorXf y = Series({0, 1, 2, 1, 0, 0});
  EXPECT_DOUBLE_EQ(DtwDistance(x, y, 1), 0.0);
  EXPECT_DOUBLE_EQ(DtwDistance(x, y, 0), 2.0) << "without a band it is the Euclidean distance";
}

TEST(DtwDistance, MatchesAHandComputedPath) {
  // The diagonal is best: 1 + 1 + 1.
  EXPECT_NEAR(DtwDistance(Series({1, 3, 4}), Series({2, 2, 5}), 2), std::sqrt(3.0), 1e-12);
  // The last 4 has to meet a 1, and the other 1 a 0: 9 + 1; the diagonal is as good.
  EXPECT_NEAR(DtwDistance(Series({0, 0, 4}), Series({0, 1, 1}), 2), std::sqrt(10.0), 1e-12);
  // 0 waits for the 5 and 5 for the end: 0 + 0 + 1 + 0, which the diagonal, 0 + 26 + 0, is not.
  EXPECT_NEAR(DtwDistance(Series({0, 0, 5}), Series({0, 5, 6}), 2), 1.0, 1e-12);
}

TEST(DtwDistance, NeverRisesWithAWiderBandAndIsSymmetric) {
  core::Random random(1);
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXf x = Moved(round % 2, 15 + random.Index(30), &random);
    const Eigen::VectorXf y = Moved(random.Index(2), 15 + random.Index(30), &random);
    double last = DtwDistance(x, y, 0);
    EXPECT_NEAR(last, (x - y).cast<double>().norm(), 1e-5);
    for (const int band : {1, 3, 10, 60}) {
      const double distance = DtwDistance(x, y, band);
      EXPECT_LE(distance, last);
      EXPECT_NEAR(distance, DtwDistance(y, x, band), 1e-9);
      last = distance;
    }
  }
}

TEST(DtwDistance, RefusesSeriesOfDifferentLengths) {
  EXPECT_THROW(DtwDistance(Series({1, 2}), Series({1}), 1), std::invalid_argument);
  EXPECT_THROW(DtwDistance(Series({}), Series({}), 1), std::invalid_argument);
}

TEST(KMedoids, FindsTheGroupsAndTheirCentres) {
  const Eigen::VectorXd places = (Eigen::VectorXd(7) << 0.0, 1.0, 2.0, 10.0, 11.0, 12.0, 13.0).finished();
  const Eigen::MatrixXd distances = (places.replicate(1, 7) - places.transpose().replicate(7, 1)).cwiseAbs();
  const KMedoidsResult result = KMedoids(distances, 2, {}, 1);
  EXPECT_DOUBLE_EQ(result.cost, 2.0 + 4.0);
  EXPECT_EQ(result.labels[0], result.labels[2]);
  EXPECT_NE(result.labels[2], result.labels[3]);
  EXPECT_EQ(result.medoids[result.labels[0]], 1);
}

TEST(KMedoids, GivesEqualItemsEveryNumberOfClustersThatFits) {
  const KMedoidsResult result = KMedoids(Eigen::MatrixXd::Zero(4, 4), 3, {}, 1);
  EXPECT_DOUBLE_EQ(result.cost, 0.0);
  EXPECT_THROW(KMedoids(Eigen::MatrixXd::Zero(2, 2), 3, {}, 1), std::invalid_argument);
}

TEST(DtwClusterer, TellsShapesApartThatMoveWithinItsBand) {
  core::Random random(2);
  std::vector<Eigen::VectorXf> series;
  Eigen::VectorXi classes(24);
  for (int index = 0; index < 24; ++index) {
    classes[index] = index % 2;
    series.push_back(Moved(index % 2, 27 + random.Index(6), &random));
  }
  DtwClusterer clusterer(DtwOptions{});
  EXPECT_EQ(ComparePartitions(clusterer.Fit(series, 2, 1), classes).rand_index, 1.0);
  const Eigen::MatrixXf features = clusterer.Transform(series);
  EXPECT_EQ(ComparePartitions(clusterer.Assign(features), classes).rand_index, 1.0);
  EXPECT_EQ(ComparePartitions(clusterer.ClusterAnew(features), classes).rand_index, 1.0);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
