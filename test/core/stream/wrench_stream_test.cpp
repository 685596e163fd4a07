#include "contact_shapelets/core/wrench_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

SegmentationOptions Options() {
  SegmentationOptions options;
  options.tare = TareSource::kService;
  return options;
}

double Rising(double time) { return 10.0 * time; }

/// Feeds samples at 100 Hz, stamped `offset` [s] ahead of their arrival; without stamps where `stamped` is false.
void Feed(WrenchStream* stream, double begin, double end, double offset = 0.0, bool stamped = true) {
  for (int index = 0; index < std::lround(100.0 * (end - begin)); ++index) {
    const double time = begin + 0.01 * index;
    EXPECT_TRUE(stream->AddWrench(stamped ? Time(time + offset) : 0, Time(time), AlongZ(Rising(time))));
  }
}

Episode Only(WrenchStream* stream) {
  const std::vector<Episode> episodes = stream->TakeEpisodes();
  EXPECT_EQ(episodes.size(), 1U);
  return episodes.empty() ? Episode() : episodes.front();
}

TEST(WrenchStream, DropsAndCountsForcesThatAreNotFiniteOrThatNoSensorMeasures) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WrenchStream stream(Options());
  Feed(&stream, 10.0, 11.0);
  stream.AddPlainEdge(true, Time(11.0));
  Feed(&stream, 11.0, 11.5);
  EXPECT_FALSE(stream.AddWrench(Time(11.501), Time(11.501), Eigen::Vector3d(0.0, kNan, 0.0)));
  EXPECT_FALSE(stream.AddWrench(Time(11.502), Time(11.502), Eigen::Vector3d(kInfinity, 0.0, 0.0)));
  EXPECT_FALSE(stream.AddWrench(Time(11.503), Time(11.503), Eigen::Vector3d(0.0, 0.0, -kInfinity)));
  EXPECT_FALSE(stream.AddWrench(Time(11.504), Time(11.504), Eigen::Vector3d(0.0, 0.0, -1e300)));
  EXPECT_FALSE(stream.AddWrench(Time(11.505), Time(11.505), Eigen::Vector3d(0.0, 8e5, 8e5)));
  Feed(&stream, 11.51, 12.1);
  stream.AddPlainEdge(false, Time(12.0));
  const Episode episode = Only(&stream);
  ASSERT_EQ(episode.force.size(), 100);
  for (int index = 0; index < 100; ++index) EXPECT_NEAR(episode.force[index], Rising(11.005 + 0.01 * index), 1e-3);
  EXPECT_EQ(stream.Summary().not_finite, 5);
  EXPECT_EQ(stream.Summary().samples, 209);
}

TEST(WrenchStream, AMessageThatIsSentAgainIsNoNews) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  stream.AddPlainEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0);
  for (int index = 0; index < 200; ++index) {
    EXPECT_FALSE(stream.AddWrench(Time(2.99), Time(3.0 + 0.01 * index), AlongZ(Rising(2.99))));
    stream.AdvanceTo(Time(3.0 + 0.01 * index));
  }
  EXPECT_EQ(Only(&stream).end_reason, EndReason::kStream);
  EXPECT_EQ(stream.Summary().repeated_messages, 200);
  EXPECT_EQ(stream.Summary().out_of_order + stream.Summary().wrong_stamps, 0);
}

TEST(WrenchStream, NewForcesUnderAStampThatStandsStillAreTakenByArrival) {
  WrenchStream stream(Options());
  for (int index = 0; index < 300; ++index) stream.AddWrench(Time(1.0), Time(1.0 + 0.01 * index), AlongZ(index));
  EXPECT_EQ(stream.Summary().samples, 250);
  EXPECT_EQ(stream.Summary().repeated, 0);
}

TEST(WrenchStream, PlacesArrivalsOnAClockThatIsHoursOff) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0, 7200.0);
  stream.AddPlainEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0, 7200.0);
  stream.AddCommand(false, Time(3.0));
  Feed(&stream, 3.0, 3.1, 7200.0);
  const Episode episode = Only(&stream);
  EXPECT_EQ(episode.start, Time(7202.0));
  ASSERT_EQ(episode.force.size(), 100);
  EXPECT_NEAR(episode.force[50], Rising(2.505), 1e-3);
  EXPECT_NEAR(stream.Summary().clock_offset, -7200.0, 1e-9);
}

TEST(WrenchStream, GivesTheSameEpisodeWithoutStamps) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0, 0.0, false);
  stream.AddPlainEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0, 0.0, false);
  stream.AddPlainEdge(false, Time(3.0));
  Feed(&stream, 3.0, 3.1, 0.0, false);
  const Episode episode = Only(&stream);
  ASSERT_EQ(episode.force.size(), 100);
  EXPECT_NEAR(episode.force[50], Rising(2.505), 1e-3);
  EXPECT_EQ(stream.Summary().zero_stamps, 210);
}

TEST(WrenchStream, OneWrongStampWithinAnEpisodeCostsNothing) {
  for (const double wrong : {-5.0, -3600.0, 5.0, 1e9}) {
    WrenchStream stream(Options());
    Feed(&stream, 4000.0, 4001.0);
    stream.AddPlainEdge(true, Time(4001.0));
    Feed(&stream, 4001.0, 4001.5);
    EXPECT_TRUE(stream.AddWrench(Time(4001.5 + wrong), Time(4001.5), AlongZ(Rising(4001.5))));
    Feed(&stream, 4001.51, 4002.0);
    stream.AddPlainEdge(false, Time(4002.0));
    Feed(&stream, 4002.0, 4002.1);
    const Episode episode = Only(&stream);
    EXPECT_TRUE(episode.complete) << wrong;
    ASSERT_EQ(episode.force.size(), 100) << wrong;
    EXPECT_NEAR(episode.force[50], Rising(4001.505), 1e-2) << wrong;
    EXPECT_EQ(stream.Summary().wrong_stamps, 1) << wrong;
    EXPECT_EQ(stream.Summary().out_of_order, 0) << wrong;
  }
}

TEST(WrenchStream, ALoopedReplayGivesTheSameEpisodesAgain) {
  WrenchStream stream(Options());
  for (int round = 0; round < 3; ++round) {
    Feed(&stream, 1.0, 2.0);
    stream.AddStampedEdge(true, Time(2.0), "", Time(2.0));
    Feed(&stream, 2.0, 3.0);
    stream.AddStampedEdge(false, Time(3.0), "", Time(3.0));
    Feed(&stream, 3.0, 4.0);
    const Episode episode = Only(&stream);
    EXPECT_EQ(episode.start, Time(2.0)) << "round " << round;
    EXPECT_EQ(episode.force.size(), 100);
  }
  EXPECT_EQ(stream.Summary().jumps_back, 2);
  EXPECT_EQ(stream.dropped_episodes(), 0);
}

TEST(WrenchStream, ALoopWithinAnEpisodeEndsItAtTheLastSample) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  stream.AddPlainEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.01);
  Feed(&stream, 1.0, 1.5);
  const Episode episode = Only(&stream);
  EXPECT_EQ(episode.end_reason, EndReason::kStream);
  EXPECT_FALSE(episode.complete);
  EXPECT_EQ(episode.force.size(), 100);
}

TEST(WrenchStream, AnEdgeWithAStampOfZeroCountsAtItsArrival) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  stream.AddStampedEdge(true, 0, "push", Time(2.0));
  Feed(&stream, 2.0, 3.0);
  stream.AddStampedEdge(false, 0, "push", Time(3.0));
  Feed(&stream, 3.0, 3.1);
  const Episode episode = Only(&stream);
  EXPECT_EQ(episode.id, "push");
  EXPECT_EQ(episode.start, Time(2.0));
  EXPECT_EQ(episode.force.size(), 100);
}

TEST(WrenchStream, TimeThatPassesWithoutASampleRunsOut) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0, 7200.0);
  stream.AddPlainEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0, 7200.0);
  stream.AdvanceTo(Time(4.5));
  EXPECT_EQ(Only(&stream).end_reason, EndReason::kStream);
}

TEST(WrenchStream, RefusesFaultyOptions) {
  SegmentationOptions options;
  options.tare_duration = -1.0;
  EXPECT_THROW(WrenchStream{options}, std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
