#include "core/change_points/window_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/change_points/planted_changes.h"

namespace contact_shapelets::core {
namespace {

/// The distance of the statistics of windows from those of the series, as the method defines it.
double Distance(const Eigen::VectorXd& series, int window) {
  const auto deviation = [](const Eigen::VectorXd& values) {
    return std::sqrt((values.array() - values.mean()).square().mean());
  };
  double sum = 0.0;
  const auto windows = series.size() - window + 1;
  for (Eigen::Index begin = 0; begin < windows; ++begin) {
    const Eigen::VectorXd part = series.segment(begin, window);
    const Eigen::Vector3d difference(part.mean() - series.mean(), deviation(part) - deviation(series),
                                     part.maxCoeff() - part.minCoeff() - 1.0);
    sum += difference.norm() / std::sqrt(window);
  }
  return sum / static_cast<double>(windows);
}

TEST(SelectWindowSize, IsTheShortestWhoseStatisticsAreNearEnoughToThoseOfTheSeries) {
  Random random(1);
  Eigen::VectorXd series = Sine(600, 80.0, &random);
  const int window = SelectWindowSize(series);
  series = ((series.array() - series.minCoeff()) / (series.maxCoeff() - series.minCoeff())).eval();
  const double all = Distance(series, 1) - Distance(series, 600);
  EXPECT_GE(Distance(series, 1) - Distance(series, window), 0.89 * all);
  EXPECT_LT(Distance(series, 1) - Distance(series, window - 1), 0.89 * all);
}

TEST(SelectWindowSize, GrowsWithThePeriod) {
  Random random(2);
  const int window = SelectWindowSize(Sine(10000, 100.0, &random));
  EXPECT_GT(window, 15);
  EXPECT_LT(window, 100);
  EXPECT_GT(SelectWindowSize(Sine(10000, 400.0, &random)), 1.3 * window);
}

TEST(SelectWindowSize, IsIndependentOfOffsetAndScale) {
  Random random(3);
  const Eigen::VectorXd series = Sine(2000, 150.0, &random);
  EXPECT_EQ(SelectWindowSize((series.array() * 1e6 + 3e7).matrix()), SelectWindowSize(series));
  EXPECT_EQ(SelectWindowSize(series * 1e90), SelectWindowSize(series));
}

TEST(SelectWindowSize, IsTheShortestForAConstantAndForAShortSeries) {
  EXPECT_EQ(SelectWindowSize(Eigen::VectorXd::Constant(500, 4.2)), kShortestWindow);
  EXPECT_EQ(SelectWindowSize(Eigen::VectorXd::LinSpaced(19, 0.0, 1.0)), kShortestWindow);
  EXPECT_EQ(SelectWindowSize(Eigen::VectorXd()), kShortestWindow);
}

TEST(SelectWindowSize, IsNeverLongerThanTheSeries) {
  for (int size = 20; size < 40; ++size) {
    const int window = SelectWindowSize(Eigen::VectorXd::LinSpaced(size, 0.0, 1.0));
    EXPECT_GE(window, kShortestWindow);
    EXPECT_LE(window, size);
  }
}

}  // namespace
}  // namespace contact_shapelets::core
