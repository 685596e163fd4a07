#include "contact_shapelets/core/wrench_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Feeds samples at 100 Hz with stamps `offset` [s] ahead of their arrival, or without stamps if `stamped` is false.
void Feed(WrenchStream* stream, double begin, double end, double offset = 0.0, bool stamped = true) {
  for (int index = 0; index < std::lround(100.0 * (end - begin)); ++index) {
    const double time = begin + 0.01 * index;
    EXPECT_TRUE(stream->AddWrench(stamped ? Time(time + offset) : 0, Time(time), Noisy(Rising(time), index)));
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
  stream.AddUnstampedEdge(true, Time(11.0));
  Feed(&stream, 11.0, 11.5);
  EXPECT_FALSE(stream.AddWrench(Time(11.501), Time(11.501), Eigen::Vector3d(0.0, kNan, 0.0)));
  EXPECT_FALSE(stream.AddWrench(Time(11.502), Time(11.502), Eigen::Vector3d(kInfinity, 0.0, 0.0)));
  EXPECT_FALSE(stream.AddWrench(Time(11.503), Time(11.503), Eigen::Vector3d(0.0, 0.0, -kInfinity)));
  EXPECT_FALSE(stream.AddWrench(Time(11.504), Time(11.504), Eigen::Vector3d(0.0, 0.0, -1e300)));
  EXPECT_FALSE(stream.AddWrench(Time(11.505), Time(11.505), Eigen::Vector3d(0.0, 8e5, 8e5)));
  Feed(&stream, 11.51, 12.1);
  stream.AddUnstampedEdge(false, Time(12.0));
  const Episode episode = Only(&stream);
  ASSERT_EQ(episode.force.size(), 100);
  for (int index = 0; index < 100; ++index) EXPECT_NEAR(episode.force[index], Rising(11.005 + 0.01 * index), 1e-3);
  EXPECT_EQ(stream.Summary().not_finite, 5);
  EXPECT_EQ(stream.Summary().samples, 209);
}

TEST(WrenchStream, AMessageThatIsSentAgainIsNoNews) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  stream.AddUnstampedEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0);
  for (int index = 0; index < 200; ++index) {
    EXPECT_FALSE(stream.AddWrench(Time(2.99), Time(3.0 + 0.01 * index), Noisy(Rising(2.99), 99)));
    stream.AdvanceTo(Time(3.0 + 0.01 * index));
  }
  EXPECT_EQ(Only(&stream).end_reason, EndReason::kStream);
  EXPECT_EQ(stream.Summary().repeated_messages, 200);
  EXPECT_EQ(stream.Summary().out_of_order + stream.Summary().wrong_stamps, 0);
}

TEST(WrenchStream, NewForcesUnderAStampThatStandsStillAreTakenByArrival) {
  WrenchStream stream(Options());
  for (int index = 0; index < 300; ++index) stream.AddWrench(Time(1.0), Time(1.0 + 0.01 * index), AlongZ(index));
  EXPECT_EQ(stream.Summary().samples, 300);
  EXPECT_EQ(stream.Summary().repeated, 0);
}

TEST(WrenchStream, PlacesArrivalsOnAClockThatIsHoursOff) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0, 7200.0);
  stream.AddUnstampedEdge(true, Time(2.0));
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
  stream.AddUnstampedEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0, 0.0, false);
  stream.AddUnstampedEdge(false, Time(3.0));
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
    stream.AddUnstampedEdge(true, Time(4001.0));
    Feed(&stream, 4001.0, 4001.5);
    EXPECT_TRUE(stream.AddWrench(Time(4001.5 + wrong), Time(4001.5), AlongZ(Rising(4001.5))));
    Feed(&stream, 4001.51, 4002.0);
    stream.AddUnstampedEdge(false, Time(4002.0));
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
  EXPECT_EQ(DroppedEpisodes(stream.Summary()), 0);
}

TEST(WrenchStream, ALoopWithinAnEpisodeEndsItAtTheLastSample) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  stream.AddUnstampedEdge(true, Time(2.0));
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

TEST(WrenchStream, AnEdgeBeforeTheFirstWrenchWaitsForTheClockOfTheStamps) {
  for (const double offset : {0.0, -1e5, 1e5}) {
    WrenchStream stream(Options());
    stream.AddUnstampedEdge(true, Time(1e4 + 1.0));
    stream.AdvanceTo(Time(1e4 + 1.9));
    EXPECT_EQ(stream.Summary().waiting_edges, 1);
    Feed(&stream, 1e4 + 2.0, 1e4 + 3.0, offset);
    EXPECT_EQ(stream.Summary().waiting_edges, 0);
    stream.AddUnstampedEdge(false, Time(1e4 + 3.0));
    Feed(&stream, 1e4 + 3.0, 1e4 + 4.0, offset);
    const Episode first = Only(&stream);
    EXPECT_EQ(first.start, Time(1e4 + 1.0 + offset));
    EXPECT_FALSE(first.complete) << "its first second is missing";
    stream.AddUnstampedEdge(true, Time(1e4 + 4.0));
    Feed(&stream, 1e4 + 4.0, 1e4 + 5.0, offset);
    stream.AddUnstampedEdge(false, Time(1e4 + 5.0));
    Feed(&stream, 1e4 + 5.0, 1e4 + 5.1, offset);
    EXPECT_TRUE(Only(&stream).complete);
  }
}

TEST(WrenchStream, EdgesFollowThisMachinesClockWhereThatIsSet) {
  for (const double step : {0.8, -0.8, 0.05}) {
    WrenchStream stream(Options());
    Feed(&stream, 10.0, 20.0);
    // From here on the step shifts all arrivals.
    const double base = 20.0 + step;
    Feed(&stream, base, base + 0.3, -step);
    stream.AddUnstampedEdge(true, Time(base + 0.3));
    Feed(&stream, base + 0.3, base + 1.3, -step);
    stream.AddUnstampedEdge(false, Time(base + 1.3));
    Feed(&stream, base + 1.3, base + 3.0, -step);
    const Episode episode = Only(&stream);
    EXPECT_NEAR(ToSeconds(episode.start), 20.3, 1e-6) << step;
    EXPECT_NEAR(static_cast<double>(episode.force.size()), 100.0, 1.0);
    EXPECT_TRUE(episode.complete);
  }
}

TEST(WrenchStream, AnEdgeFromBeforeASettingOfTheClockKeepsItsPlace) {
  WrenchStream stream(Options());
  Feed(&stream, 10.0, 20.0);
  stream.AddUnstampedEdge(true, Time(19.995));
  Feed(&stream, 20.8, 22.0, -0.8);
  stream.AddUnstampedEdge(false, Time(22.0));
  Feed(&stream, 22.0, 23.0, -0.8);
  const Episode episode = Only(&stream);
  EXPECT_NEAR(ToSeconds(episode.start), 19.995, 1e-6);
  EXPECT_NEAR(episode.duration(), 1.205, 0.011);
}

TEST(WrenchStream, ADriverWhoseClockIsSetInAnEpisodeMakesThatIncompleteAndNoOther) {
  for (const double step : {0.4, -0.4}) {
    WrenchStream stream(Options());
    Feed(&stream, 10.0, 11.0);
    stream.AddUnstampedEdge(true, Time(11.0));
    Feed(&stream, 11.0, 11.5);
    Feed(&stream, 11.5, 12.0, step);
    stream.AddUnstampedEdge(false, Time(12.0));
    Feed(&stream, 12.0, 13.0, step);
    EXPECT_FALSE(Only(&stream).complete);
    stream.AddUnstampedEdge(true, Time(13.0));
    Feed(&stream, 13.0, 14.0, step);
    stream.AddUnstampedEdge(false, Time(14.0));
    Feed(&stream, 14.0, 14.1, step);
    const Episode episode = Only(&stream);
    EXPECT_TRUE(episode.complete);
    EXPECT_EQ(episode.start, Time(13.0 + step));
    EXPECT_EQ(stream.Summary().episode_faults[static_cast<std::size_t>(EpisodeFault::kClockSet)], 1);
  }
}

/// Cuts two episodes of one second by stamped edges with stamps `early` seconds before their arrival.
std::vector<Episode> EarlyEdges(double early, StreamSummary* summary) {
  WrenchStream stream(Options());
  Feed(&stream, 100.0, 140.0);
  for (const double begin : {140.0, 142.0}) {
    stream.AddStampedEdge(true, Time(begin - early), "", Time(begin), "sequencer");
    Feed(&stream, begin, begin + 1.0);
    stream.AddStampedEdge(false, Time(begin + 1.0 - early), "", Time(begin + 1.0), "sequencer");
    Feed(&stream, begin + 1.0, begin + 2.0);
  }
  *summary = stream.Summary();
  return stream.TakeEpisodes();
}

TEST(WrenchStream, StampedEdgesByAClockThatIsOffCountAtTheirArrivalAndAreNamed) {
  for (const double early : {0.2, 1.0, 1.5, 30.0, 3600.0, -0.2, -3600.0}) {
    StreamSummary summary;
    const std::vector<Episode> episodes = EarlyEdges(early, &summary);
    ASSERT_EQ(episodes.size(), 2U) << early;
    EXPECT_EQ(episodes[0].start, Time(140.0)) << early;
    EXPECT_EQ(episodes[1].start, Time(142.0)) << early;
    for (const Episode& episode : episodes) EXPECT_EQ(episode.force.size(), 100) << early;
    EXPECT_GT(summary.distrusted_edges, 0);
    EXPECT_NEAR(summary.edge_lateness, early, 1e-3);
  }
}

TEST(WrenchStream, AnEdgeStampedFarAheadCountsAtItsArrival) {
  WrenchStream stream(Options());
  Feed(&stream, 100.0, 140.0);
  for (const double begin : {140.0, 142.0, 144.0}) {
    stream.AddStampedEdge(true, Time(begin), "", Time(begin), "sequencer");
    Feed(&stream, begin, begin + 1.0);
    const double ahead = begin == 140.0 ? 25.0 : 0.0;
    stream.AddStampedEdge(false, Time(begin + 1.0 + ahead), "", Time(begin + 1.0), "sequencer");
    Feed(&stream, begin + 1.0, begin + 2.0);
  }
  const std::vector<Episode> episodes = stream.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 3U);
  for (const Episode& episode : episodes) EXPECT_EQ(episode.force.size(), 100);
  EXPECT_GT(stream.Summary().distrusted_edges, 0);
}

TEST(WrenchStream, StampedEdgesThatATransportDelaysAreExact) {
  StreamSummary summary;
  const std::vector<Episode> episodes = EarlyEdges(0.09, &summary);
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_EQ(episodes[0].start, Time(139.91));
  EXPECT_EQ(episodes[1].start, Time(141.91));
  EXPECT_EQ(summary.distrusted_edges, 0);
}

TEST(WrenchStream, AStampedOpeningThatWasDecidedOnLateIsExactWhereItsClosingIsInTime) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 10.0);
  for (const double begin : {10.0, 14.0}) {
    // Contact segmentation with a pre-trigger of 2 s gives such edges.
    Feed(&stream, begin, begin + 2.0);
    stream.AddStampedEdge(true, Time(begin), "", Time(begin + 2.0), "node");
    Feed(&stream, begin + 2.0, begin + 3.0);
    stream.AddStampedEdge(false, Time(begin + 3.0), "", Time(begin + 3.0), "node");
    Feed(&stream, begin + 3.0, begin + 4.0);
    const Episode episode = Only(&stream);
    EXPECT_EQ(episode.start, Time(begin));
    EXPECT_EQ(episode.force.size(), 300);
  }
  EXPECT_EQ(stream.Summary().distrusted_edges, 0);
}

TEST(WrenchStream, BoolsFirstAndStampedEdgesLaterGiveAllEpisodes) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  for (int index = 0; index < 6; ++index) {
    const double begin = 2.0 + 2.0 * index;
    const auto edge = [&](bool open, double time) {
      index < 3 ? stream.AddUnstampedEdge(open, Time(time))
                : stream.AddStampedEdge(open, Time(time), "", Time(time), "s");
    };
    edge(true, begin);
    Feed(&stream, begin, begin + 1.0);
    edge(false, begin + 1.0);
    Feed(&stream, begin + 1.0, begin + 2.0);
  }
  EXPECT_EQ(stream.TakeEpisodes().size(), 6U);
}

TEST(WrenchStream, HowOftenTimeIsLetPassMakesNoDifference) {
  const auto play = [](double step) {
    WrenchStream stream(Options());
    Feed(&stream, 1.0, 2.0);
    stream.AddUnstampedEdge(true, Time(2.0));
    Feed(&stream, 2.0, 4.0);
    for (double time = 4.0; time < 9.0; time += step) stream.AdvanceTo(Time(time));
    Feed(&stream, 9.0, 10.0);
    stream.AddUnstampedEdge(false, Time(10.0));
    Feed(&stream, 10.0, 10.1);
    return Only(&stream);
  };
  for (const double step : {0.001, 0.3, 10.0}) {
    const Episode episode = play(step);
    EXPECT_EQ(episode.end_reason, EndReason::kStream) << step;
    EXPECT_EQ(episode.force.size(), 199) << step;
    EXPECT_FALSE(episode.complete);
  }
}

TEST(WrenchStream, TwoPublishersThatTakeTurnsAreNamedAndARestartIsNot) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  for (const char* const name : {"/driver", "/driver_2", "/driver_2"}) stream.SetPublisher(name);
  EXPECT_EQ(stream.Summary().publisher_turns, 0);
  for (const char* const name : {"/driver", "/driver_2", "/driver"}) stream.SetPublisher(name);
  EXPECT_EQ(stream.Summary().publisher_turns, 3);
}

TEST(WrenchStream, AnActionsStatusCountsWhereItChanges) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0);
  for (int index = 0; index < 40; ++index) {
    const double time = 2.0 + 0.1 * index;
    stream.AddStatus(index >= 5 && index < 25, Time(time));
    Feed(&stream, time, time + 0.1);
  }
  EXPECT_EQ(Only(&stream).force.size(), 200);
  EXPECT_EQ(stream.Summary().repeated_openings, 0);
}

TEST(WrenchStream, TimeThatPassesWithoutASampleRunsOut) {
  WrenchStream stream(Options());
  Feed(&stream, 1.0, 2.0, 7200.0);
  stream.AddUnstampedEdge(true, Time(2.0));
  Feed(&stream, 2.0, 3.0, 7200.0);
  stream.AdvanceTo(Time(4.5));
  EXPECT_EQ(Only(&stream).end_reason, EndReason::kStream);
}

bool Finds(const std::vector<Finding>& findings, const std::string& part) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& finding) { return finding.text.find(part) != std::string::npos; });
}

TEST(WrenchStream, AReplayAtAnotherRateIsNamedAndNoClockIsBlamed) {
  for (const double rate : {0.5, 0.9, 1.1, 2.0, 4.0}) {
    WrenchStream stream(Options());
    for (int index = 0; index < 3000; ++index) {
      stream.AddWrench(Time(100.0 + 0.01 * index), Time(5000.0 + 0.01 * index / rate), Noisy(0.0, index));
    }
    EXPECT_NEAR(stream.Summary().clock_rate, rate, 0.01 * rate);
    EXPECT_TRUE(Finds(FindingsOf(stream.Summary()), "times as fast as this machine's time")) << rate;
    EXPECT_FALSE(Finds(FindingsOf(stream.Summary()), "was set")) << rate;
    EXPECT_FALSE(Finds(FindingsOf(stream.Summary()), "ppm")) << rate;
  }
}

TEST(WrenchStream, ClocksThatDriftOrAreSetAreNoReplayAtAnotherRate) {
  for (const double step : {-0.8, 0.0, 0.8}) {
    WrenchStream stream(Options());
    for (int index = 0; index < 3000; ++index) {
      const double time = 0.01 * index;
      const double arrival = 5000.0 + 1.0005 * time + (time > 15.0 ? step : 0.0) + 0.02 * (index % 3);
      stream.AddWrench(Time(100.0 + time), Time(arrival), Noisy(0.0, index));
      EXPECT_EQ(stream.Summary().clock_rate, 1.0) << step << " at " << time;
    }
  }
}

/// Adds Bools for two pushes of one second, which begin at 11 s and 15 s, without the edge at `lost` [s].
StreamSummary TwoPushesWithout(double lost) {
  WrenchStream stream(Options());
  Feed(&stream, 10.0, 11.0);
  for (const double edge : {11.0, 12.0, 15.0, 16.0}) {
    if (edge != lost) stream.AddUnstampedEdge(edge == 11.0 || edge == 15.0, Time(edge));
    // A sequencer may repeat its state.
    if (edge == 12.0) stream.AddUnstampedEdge(false, Time(12.5));
    Feed(&stream, edge, edge == 12.0 ? 15.0 : edge + 1.0);
  }
  return stream.Summary();
}

TEST(WrenchStream, ALostOpeningIsAFinding) {
  EXPECT_TRUE(Finds(EpisodeFindingsOf(TwoPushesWithout(15.0)), "closings came while no episode was open"));
  EXPECT_EQ(TwoPushesWithout(0.0).lost_openings, 0);
}

TEST(WrenchStream, TheClosingOfAnEpisodeThatWasCutIsNoLostOpening) {
  SegmentationOptions options = Options();
  options.max_duration = 2.0;
  WrenchStream stream(options);
  Feed(&stream, 10.0, 11.0);
  for (const double begin : {11.0, 17.0}) {
    stream.AddUnstampedEdge(true, Time(begin));
    Feed(&stream, begin, begin + 5.0);
    stream.AddUnstampedEdge(false, Time(begin + 5.0));
    Feed(&stream, begin + 5.0, begin + 6.0);
  }
  EXPECT_EQ(stream.Summary().lost_openings, 0);
}

TEST(WrenchStream, ContactThatNeverFindsAFreeAirForceIsAFinding) {
  SegmentationOptions options = Options();
  options.segmentation = SegmentationMode::kContact;
  for (const double amplitude : {0.0, 30.0}) {
    WrenchStream stream(options);
    for (int index = 0; index < 1000; ++index) {
      const double time = 0.01 * index;
      stream.AddWrench(Time(10.0 + time), Time(10.0 + time), Noisy(amplitude * std::sin(6.0 * time), index));
    }
    EXPECT_EQ(Finds(EpisodeFindingsOf(stream.Summary()), "no free-air force"), amplitude > 0.0);
  }
}

TEST(WrenchStream, RefusesFaultyOptions) {
  SegmentationOptions options;
  options.tare_duration = -1.0;
  EXPECT_THROW(WrenchStream{options}, std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
