#include "core/change_points/streaming_clasp.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/change_points/planted_changes.h"

namespace contact_shapelets::core {
namespace {

struct Report {
  std::vector<ChangePoint> points;
  std::vector<std::int64_t> at;  ///< samples taken when each was found
  int window = 0;
};

Report Play(const Eigen::VectorXd& series, const StreamingClaspOptions& options) {
  Report report;
  StreamingClasp clasp(options);
  std::int64_t taken = 0;
  const auto note = [&](const std::vector<ChangePoint>& found) {
    report.points.insert(report.points.end(), found.begin(), found.end());
    report.at.insert(report.at.end(), found.size(), taken);
  };
  for (Eigen::Index index = 0; index < series.size(); ++index) {
    ++taken;
    note(clasp.Append(series[index]));
  }
  note(clasp.Flush());
  report.window = clasp.window();
  return report;
}

StreamingClaspOptions WithWindow(int window) {
  StreamingClaspOptions options;
  options.window = window;
  return options;
}

/// 6000 samples whose shape changes at 2000, 3500 and 4800, back to the first one at the end.
Eigen::VectorXd FourShapes(std::uint64_t seed) {
  Random random(seed);
  return Concatenated(
      {Sine(2000, 40.0, &random), Sawtooth(1500, 40, &random), Sine(1300, 25.0, &random), Sine(1200, 40.0, &random)});
}

TEST(StreamingClasp, FindsEveryChangeWhileTheNextShapeLasts) {
  const Report report = Play(FourShapes(1), WithWindow(20));
  ASSERT_TRUE(AreAt(report.points, {2000, 3500, 4800}, 20));
  EXPECT_LT(report.at[0], 3500);
  EXPECT_LT(report.at[1], 4800);
  EXPECT_LT(report.at[2], 6000);
}

TEST(StreamingClasp, ChoosesTheWindowByTheWarmUp) {
  StreamingClaspOptions options;
  options.warm_up = 1000;
  const Report report = Play(FourShapes(2), options);
  EXPECT_GE(report.window, 10);
  EXPECT_LT(report.window, 40);
  EXPECT_TRUE(AreAt(report.points, {2000, 3500, 4800}, report.window));
}

TEST(StreamingClasp, FindsChangesWithinTheWarmUpSoonAfterIt) {
  StreamingClaspOptions options;
  options.warm_up = 5000;
  const Report report = Play(FourShapes(3), options);
  ASSERT_TRUE(AreAt(report.points, {2000, 3500, 4800}, report.window));
  EXPECT_GE(report.at[0], 5000);
  EXPECT_LT(report.at[1], 5000 + 5000 / 7);
}

TEST(StreamingClasp, FindsChangesOfAStreamThatEndsWithinTheWarmUp) {
  const Report report = Play(FourShapes(4), StreamingClaspOptions());
  EXPECT_TRUE(AreAt(report.points, {2000, 3500, 4800}, report.window));
}

TEST(StreamingClasp, FindsNoneInAStreamOfOneShapeThatIsLongerThanTheSlidingWindow) {
  // Neighbours that have left the sliding window would pass for those of another shape.
  StreamingClaspOptions options;
  options.sliding_window = options.warm_up = 3000;
  Random random(5);
  EXPECT_TRUE(AreAt(Play(Noise(15000, &random), options).points, {}, 0));
  EXPECT_TRUE(AreAt(Play(Sine(15000, 40.0, &random), options).points, {}, 0));
}

TEST(StreamingClasp, FindsNoneInAStreamThatRepeatsItselfExactly) {
  Eigen::VectorXd series(8000);
  for (int index = 0; index < series.size(); ++index) series[index] = index * index % 37;
  EXPECT_TRUE(AreAt(Play(series, StreamingClaspOptions()).points, {}, 0));
}

TEST(StreamingClasp, FindsAChangeAfterTheSlidingWindowHasMoved) {
  StreamingClaspOptions options = WithWindow(20);
  options.sliding_window = 3000;
  Random random(6);
  const Report report = Play(Concatenated({Sine(20000, 40.0, &random), Sawtooth(2000, 40, &random)}), options);
  EXPECT_TRUE(AreAt(report.points, {20000}, 20));
}

TEST(StreamingClasp, FindsAConstantStretchInNoise) {
  Random random(7);
  const Eigen::VectorXd series =
      Concatenated({Noise(1500, &random), Eigen::VectorXd::Constant(1200, 0.5), Noise(1500, &random)});
  EXPECT_TRUE(AreAt(Play(series, WithWindow(20)).points, {1500, 2700}, 20));
}

TEST(StreamingClasp, FindsNoneInAConstantOrShortStream) {
  EXPECT_TRUE(AreAt(Play(Eigen::VectorXd::Constant(3000, 7.0), StreamingClaspOptions()).points, {}, 0));
  EXPECT_TRUE(AreAt(Play(FourShapes(8).segment(1950, 100), StreamingClaspOptions()).points, {}, 0));
  EXPECT_TRUE(AreAt(Play(Eigen::VectorXd(), StreamingClaspOptions()).points, {}, 0));
}

TEST(StreamingClasp, IsIndependentOfOffsetAndScale) {
  const Eigen::VectorXd series = FourShapes(9);
  const Report report = Play(series, WithWindow(20));
  ASSERT_EQ(report.points.size(), 3U);
  const Report large = Play((1e90 * series.array() + 1e95).matrix(), WithWindow(20));
  EXPECT_TRUE(AreAt(large.points, {report.points[0].index, report.points[1].index, report.points[2].index}, 0));
}

TEST(StreamingClasp, RefusesWhatIsNotANumberAndGoesOn) {
  const Eigen::VectorXd series = FourShapes(10);
  StreamingClasp clasp(WithWindow(20));
  std::vector<ChangePoint> points;
  for (Eigen::Index index = 0; index < series.size(); ++index) {
    if (index == 2500) {
      EXPECT_THROW(clasp.Append(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
      EXPECT_THROW(clasp.Append(-std::numeric_limits<double>::infinity()), std::invalid_argument);
    }
    for (const ChangePoint& point : clasp.Append(series[index])) points.push_back(point);
  }
  EXPECT_TRUE(AreAt(points, {2000, 3500, 4800}, 20));
}

TEST(StreamingClasp, GivesTheSameForTheSameStream) {
  const Report first = Play(FourShapes(11), WithWindow(20));
  const Report second = Play(FourShapes(11), WithWindow(20));
  EXPECT_EQ(first.at, second.at);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t index = 0; index < first.points.size(); ++index) {
    EXPECT_EQ(first.points[index].index, second.points[index].index);
    EXPECT_EQ(first.points[index].p_value, second.points[index].p_value);
  }
}

TEST(StreamingClasp, KeepsTheChosenWindowShortEnoughForTheSlidingWindow) {
  StreamingClaspOptions options;
  options.sliding_window = 400;
  options.warm_up = 2000;
  EXPECT_LE(Play(Eigen::VectorXd::LinSpaced(2500, 0.0, 1.0), options).window, 20);
}

TEST(StreamingClasp, NamesEveryFaultOfTheOptions) {
  StreamingClaspOptions options;
  options.window = 1;
  options.warm_up = 19;
  options.sliding_window = 199;
  options.neighbours = 0;
  options.stride = 0;
  options.significance = 1.0;
  options.shortest_segment = 1;
  const std::string faults = options.Faults();
  for (const char* name :
       {"window", "warm_up", "sliding_window", "neighbours", "stride", "significance", "shortest_segment"}) {
    EXPECT_NE(faults.find(name), std::string::npos) << name;
  }
  EXPECT_THROW(StreamingClasp clasp(options), std::invalid_argument);
  EXPECT_EQ(StreamingClaspOptions().Faults(), "");
}

}  // namespace
}  // namespace contact_shapelets::core
