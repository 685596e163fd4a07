#include "core/change_points/clasp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/change_points/planted_changes.h"

namespace contact_shapelets::core {
namespace {

/// 3000 samples whose shape changes at 1000 and 1800.
Eigen::VectorXd ThreeShapes(std::uint64_t seed) {
  Random random(seed);
  return Concatenated({Sine(1000, 40.0, &random), Sawtooth(800, 40, &random), Sine(1200, 25.0, &random)});
}

TEST(FindChangePoints, FindsWhereTheShapeChanges) {
  const ChangePoints found = FindChangePoints(ThreeShapes(1));
  EXPECT_TRUE(AreAt(found.points, {1000, 1800}, found.window));
  for (const ChangePoint& point : found.points) {
    EXPECT_GT(point.score, 0.8);
    EXPECT_LE(point.p_value, 1e-15);
  }
}

TEST(FindChangePoints, FindsAStateThatReturns) {
  Random random(2);
  const Eigen::VectorXd series =
      Concatenated({Sine(1000, 40.0, &random), Sawtooth(1500, 30, &random), Sine(1000, 40.0, &random)});
  const ChangePoints found = FindChangePoints(series);
  EXPECT_TRUE(AreAt(found.points, {1000, 2500}, found.window));
}

TEST(FindChangePoints, FindsNoneInASeriesOfOneShape) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    EXPECT_TRUE(AreAt(FindChangePoints(Noise(3000, &random)).points, {}, 0));
    EXPECT_TRUE(AreAt(FindChangePoints(Sine(3000, 40.0, &random)).points, {}, 0));
  }
}

TEST(FindChangePoints, FindsNoneInASeriesThatRepeatsItselfExactly) {
  Eigen::VectorXd series(4000);
  for (int index = 0; index < series.size(); ++index) series[index] = index * index % 37;
  EXPECT_TRUE(AreAt(FindChangePoints(series).points, {}, 0));
}

TEST(FindChangePoints, FindsAConstantStretchInNoise) {
  Random random(3);
  const Eigen::VectorXd series =
      Concatenated({Noise(800, &random), Eigen::VectorXd::Constant(700, 0.5), Noise(900, &random)});
  const ChangePoints found = FindChangePoints(series);
  EXPECT_TRUE(AreAt(found.points, {800, 1500}, found.window));
}

TEST(FindChangePoints, FindsNoneInAConstantSeries) {
  EXPECT_TRUE(AreAt(FindChangePoints(Eigen::VectorXd::Constant(2000, 0.0)).points, {}, 0));
  EXPECT_TRUE(AreAt(FindChangePoints(Eigen::VectorXd::Constant(2000, 1e99)).points, {}, 0));
}

TEST(FindChangePoints, FindsNoneInASeriesShorterThanTwoSegments) {
  Random random(4);
  const Eigen::VectorXd series = Concatenated({Sine(150, 40.0, &random), Sine(150, 10.0, &random)});
  ClaspOptions options;
  options.window = 30;
  // 150 samples, that is, 5 windows, on either side of the change, then one sample less.
  EXPECT_TRUE(AreAt(FindChangePoints(series, options).points, {150}, 0));
  EXPECT_TRUE(AreAt(FindChangePoints(series.head(299), options).points, {}, 0));
  EXPECT_TRUE(AreAt(FindChangePoints(series.head(3)).points, {}, 0));
  EXPECT_TRUE(AreAt(FindChangePoints(Eigen::VectorXd()).points, {}, 0));
}

TEST(FindChangePoints, IsIndependentOfOffsetAndScale) {
  const Eigen::VectorXd series = ThreeShapes(5);
  const ChangePoints found = FindChangePoints(series);
  ASSERT_EQ(found.points.size(), 2U);
  for (const double scale : {1e-90, 1e6, 1e99}) {
    EXPECT_TRUE(AreAt(FindChangePoints(scale * series).points, {found.points[0].index, found.points[1].index}, 0));
  }
  const Eigen::VectorXd far = series.array() + 1e6;
  EXPECT_TRUE(AreAt(FindChangePoints(far).points, {found.points[0].index, found.points[1].index}, 0));
}

TEST(FindChangePoints, GivesTheSameForTheSameSeries) {
  const ChangePoints first = FindChangePoints(ThreeShapes(6));
  const ChangePoints second = FindChangePoints(ThreeShapes(6));
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t index = 0; index < first.points.size(); ++index) {
    EXPECT_EQ(first.points[index].index, second.points[index].index);
    EXPECT_EQ(first.points[index].score, second.points[index].score);
    EXPECT_EQ(first.points[index].p_value, second.points[index].p_value);
  }
}

TEST(FindChangePoints, AveragesALongSeries) {
  Random random(7);
  const Eigen::VectorXd series = Concatenated({Sine(14000, 400.0, &random), Sawtooth(16010, 400, &random)});
  ClaspOptions options;
  options.max_samples = 6000;
  const ChangePoints found = FindChangePoints(series, options);
  EXPECT_EQ(found.block, 6);
  EXPECT_EQ(found.window % 6, 0);
  EXPECT_TRUE(AreAt(found.points, {14000}, found.window));
  EXPECT_EQ(found.points[0].index % 6, 0);
}

TEST(FindChangePoints, TakesTheGivenWindow) {
  ClaspOptions options;
  options.window = 33;
  EXPECT_EQ(FindChangePoints(ThreeShapes(8), options).window, 33);
}

TEST(FindChangePoints, FindsNoMoreThanTheSignificanceAllows) {
  ClaspOptions options;
  options.significance = 1e-300;
  EXPECT_TRUE(AreAt(FindChangePoints(ThreeShapes(9), options).points, {}, 0));
}

TEST(FindChangePoints, RefusesWhatIsNotANumberAndNamesThePlace) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e101}) {
    Eigen::VectorXd series = ThreeShapes(10);
    series[1234] = bad;
    try {
      FindChangePoints(series);
      FAIL() << "took " << bad;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("sample 1234"), std::string::npos) << error.what();
    }
  }
}

TEST(FindChangePoints, NamesEveryFaultOfTheOptions) {
  ClaspOptions options;
  options.window = 2;
  options.neighbours = 16;
  options.significance = 0.0;
  options.shortest_segment = 1;
  options.max_samples = 99;
  const std::string faults = options.Faults();
  for (const char* name : {"window", "neighbours", "significance", "shortest_segment", "max_samples"}) {
    EXPECT_NE(faults.find(name), std::string::npos) << name;
  }
  EXPECT_THROW(FindChangePoints(ThreeShapes(11), options), std::invalid_argument);
  EXPECT_EQ(ClaspOptions().Faults(), "");
}

}  // namespace
}  // namespace contact_shapelets::core
