#include "core/learning/series_distances.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

std::vector<Eigen::VectorXf> SeriesOfTwoLengths(int count) {
  Random random(5);
  std::vector<Eigen::VectorXf> series;
  for (int index = 0; index < count; ++index) {
    series.push_back(Eigen::VectorXf::NullaryExpr(
        index % 2 == 0 ? 3 : 5, [&random](Eigen::Index) { return static_cast<float>(random.Normal()); }));
  }
  return series;
}

/// Expects the distances of some of `count` series of five samples. Stretched to three, they keep every other sample.
void ExpectDistancesOfSome(int count) {
  const std::vector<Eigen::VectorXf> series = SeriesOfTwoLengths(count);
  const std::vector<int> chosen{count - 1, 0, 3};
  const auto value = [&](int index, int sample) {
    const Eigen::VectorXf& one = series[static_cast<std::size_t>(index)];
    return static_cast<double>(one.size() == 3 ? one[sample] : one[2 * sample]);
  };
  const Eigen::MatrixXd distances = SeriesDistances(series, 3).Among(chosen);
  ASSERT_EQ(distances.rows(), 3);
  ASSERT_EQ(distances.cols(), 3);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      double expected = 0.0;
      for (int sample = 0; sample < 3; ++sample) {
        const double difference = value(chosen[row], sample) - value(chosen[column], sample);
        expected += difference * difference;
      }
      EXPECT_NEAR(distances(row, column), expected, 1e-5) << row << ' ' << column;
    }
  }
}

TEST(SeriesDistances, AreThoseOfTheChosenSeriesStretchedToOneLength) { ExpectDistancesOfSome(7); }

TEST(SeriesDistances, AreTheSameIfThereAreTooManySeriesForATable) { ExpectDistancesOfSome(2501); }

}  // namespace
}  // namespace contact_shapelets::core
