#include "core/stream/episode_segmenter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

SegmentationOptions Options() {
  SegmentationOptions options;
  options.tare = TareSource::kService;  // zero, so that forces stay as they are
  return options;
}

double Rising(double time) { return 10.0 * time; }

void Edge(EpisodeSegmenter* segmenter, bool open, EdgeSource source, double time, double now, const char* id = "") {
  const PlacedEdge placed{{open, Time(time), source, id, Time(now)},
                          Time(time),
                          Time(now),
                          false,
                          std::max<Nanoseconds>(0, Time(time) - Time(now))};
  segmenter->AddEdge(placed, Time(now));
}

void Unstamped(EpisodeSegmenter* segmenter, bool open, double now) {
  Edge(segmenter, open, EdgeSource::kUnstamped, now, now);
}

void Stamped(EpisodeSegmenter* segmenter, bool open, double time, double now, const char* id = "") {
  Edge(segmenter, open, EdgeSource::kStamped, time, now, id);
}

/// Expects the rising force from `begin` on, 0.01 s per value.
void ExpectRising(const Episode& episode, double begin, int count) {
  EXPECT_EQ(episode.start, Time(begin));
  ASSERT_EQ(episode.force.size(), count);
  for (int index = 0; index < count; ++index) {
    EXPECT_NEAR(episode.force[index], Rising(begin + 0.01 * (index + 0.5)), 1e-4) << index;
  }
}

TEST(EpisodeSegmenter, CutsFromTheUnstampedOpeningToTheUnstampedClosing) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.0);
  Unstamped(&segmenter, true, 1.0);
  EXPECT_TRUE(segmenter.IsOpen());
  Feed(&segmenter, Rising, 1.0, 2.0);
  Unstamped(&segmenter, false, 2.0);
  EXPECT_FALSE(segmenter.IsOpen());
  Feed(&segmenter, Rising, 2.0, 2.1);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
  EXPECT_TRUE(episodes[0].complete);
  EXPECT_EQ(episodes[0].end_reason, EndReason::kTrigger);
  EXPECT_EQ(episodes[0].id, "1.000");
  EXPECT_TRUE(segmenter.TakeEpisodes().empty());
}

TEST(EpisodeSegmenter, CutsByStampsWhateverTheArrivals) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.6);
  Stamped(&segmenter, true, 1.0, 1.6, "push");
  Feed(&segmenter, Rising, 1.6, 2.5);
  Stamped(&segmenter, false, 2.0, 2.5);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
  EXPECT_EQ(episodes[0].id, "push");
}

TEST(EpisodeSegmenter, AClosingWaitsForTheSamplesBeforeIt) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.95);
  Stamped(&segmenter, true, 1.0, 1.95);
  Stamped(&segmenter, false, 2.0, 2.0);
  EXPECT_TRUE(segmenter.TakeEpisodes().empty());
  Feed(&segmenter, Rising, 1.95, 2.01, 100.0, 0.04);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
}

TEST(EpisodeSegmenter, AClosingWaitsNoLongerThanTheEdgeWait) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.5);
  Feed(&segmenter, Rising, 0.5, 1.0);
  Unstamped(&segmenter, false, 1.0);
  segmenter.AdvanceTo(Time(1.049));
  EXPECT_FALSE(segmenter.TakeEpisodes().size());
  segmenter.AdvanceTo(Time(1.05));
  EXPECT_EQ(segmenter.TakeEpisodes().size(), 1U);
}

TEST(EpisodeSegmenter, AClosingThatIsStampedAheadWaitsForItsSamples) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.8);
  Stamped(&segmenter, true, 1.0, 1.8);
  Stamped(&segmenter, false, 2.0, 1.8);
  Feed(&segmenter, Rising, 1.8, 2.01);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
}

TEST(EpisodeSegmenter, AnOpeningMayArriveBeforeItsSamples) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 0.9, 100.0, 0.1);
  Stamped(&segmenter, true, 1.0, 1.0);
  Feed(&segmenter, Rising, 0.9, 2.1, 100.0, 0.1);
  Stamped(&segmenter, false, 2.0, 2.2);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
}

TEST(EpisodeSegmenter, TheNextEpisodeMayOpenWhileTheLastWaits) {
  EpisodeSegmenter segmenter(Options());
  Stamped(&segmenter, true, 1.0, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.98, 100.0, 0.02);
  Stamped(&segmenter, false, 2.0, 2.0);
  Stamped(&segmenter, true, 2.0, 2.0);
  Feed(&segmenter, Rising, 1.98, 3.01, 100.0, 0.02);
  Stamped(&segmenter, false, 3.0, 3.0);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 2U);
  ExpectRising(episodes[0], 1.0, 100);
  ExpectRising(episodes[1], 2.0, 100);
}

TEST(EpisodeSegmenter, AStampedOpeningCorrectsTheUnstampedOneAndItsName) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.1);
  Unstamped(&segmenter, true, 1.1);
  Stamped(&segmenter, true, 1.0, 1.1);
  Feed(&segmenter, Rising, 1.1, 2.05);
  Unstamped(&segmenter, false, 2.05);
  Stamped(&segmenter, false, 2.0, 2.05);
  Feed(&segmenter, Rising, 2.05, 2.1);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
  EXPECT_EQ(episodes[0].id, "1.000");
  const std::vector<EpisodeEdge> edges = segmenter.TakeEdges();
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[1].time, Time(1.0));
  EXPECT_EQ(edges[1].id, "1.000");
}

TEST(EpisodeSegmenter, UnstampedTwinsOfStampedEdgesAreNoEdgesOfTheirOwn) {
  EpisodeSegmenter segmenter(Options());
  for (const double begin : {0.0, 2.0, 4.0}) {
    Feed(&segmenter, Rising, begin, begin + 1.0);
    Stamped(&segmenter, true, begin + 1.0, begin + 1.0);
    Unstamped(&segmenter, true, begin + 1.02);
    Feed(&segmenter, Rising, begin + 1.0, begin + 1.5);
    Stamped(&segmenter, false, begin + 1.5, begin + 1.5);
    // The next episode opens before the twin of the last closing comes.
    Stamped(&segmenter, true, begin + 1.51, begin + 1.51);
    Unstamped(&segmenter, false, begin + 1.52);
    Unstamped(&segmenter, true, begin + 1.53);
    Feed(&segmenter, Rising, begin + 1.5, begin + 1.9);
    Stamped(&segmenter, false, begin + 1.9, begin + 1.9);
    Unstamped(&segmenter, false, begin + 1.92);
    Feed(&segmenter, Rising, begin + 1.9, begin + 2.0);
  }
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 6U);
  for (const Episode& episode : episodes) EXPECT_TRUE(episode.complete);
  EXPECT_EQ(segmenter.repeated_openings(), 0);
}

TEST(EpisodeSegmenter, AStrayStampedEdgeDoesNotTurnUnstampedOnesOff) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 0.5);
  Stamped(&segmenter, false, 0.5, 0.5);
  for (const double begin : {1.0, 2.0, 3.0}) {
    Feed(&segmenter, Rising, begin - 0.5, begin);
    Unstamped(&segmenter, true, begin);
    Feed(&segmenter, Rising, begin, begin + 0.5);
    Unstamped(&segmenter, false, begin + 0.5);
  }
  Feed(&segmenter, Rising, 3.5, 4.0);
  EXPECT_EQ(segmenter.TakeEpisodes().size(), 3U);
}

TEST(EpisodeSegmenter, AnUnstampedClosingEndsAStampedEpisodeIfItsTwinIsLost) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.0);
  Stamped(&segmenter, true, 1.0, 1.0);
  Feed(&segmenter, Rising, 1.0, 2.0);
  Unstamped(&segmenter, false, 2.0);
  Feed(&segmenter, Rising, 2.0, 2.2);
  EXPECT_TRUE(segmenter.TakeEpisodes().empty()) << "the stamped closing may still come";
  Feed(&segmenter, Rising, 2.2, 2.3);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
  EXPECT_TRUE(episodes[0].complete);
}

TEST(EpisodeSegmenter, AnEpisodeWhoseClosingWasLostIsNotComplete) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.0);
  Stamped(&segmenter, true, 1.0, 1.0, "first");
  Feed(&segmenter, Rising, 1.0, 3.0);
  Stamped(&segmenter, true, 3.0, 3.0, "second");
  Feed(&segmenter, Rising, 3.0, 4.0);
  Stamped(&segmenter, false, 4.0, 4.0, "second");
  Feed(&segmenter, Rising, 4.0, 4.1);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_FALSE(episodes[0].complete);
  EXPECT_TRUE(episodes[1].complete);
  ExpectRising(episodes[1], 3.0, 100);
  EXPECT_EQ(segmenter.fault_counts()[static_cast<std::size_t>(EpisodeFault::kClosingLost)], 1);
}

TEST(EpisodeSegmenter, ARecordingOfItsOwnEdgesBesideTheOriginalsGivesEachEpisodeOnce) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 3.0);
  // The echo of an edge may be recorded after the next edge.
  Stamped(&segmenter, true, 1.0, 3.0, "first");
  Stamped(&segmenter, false, 1.5, 3.0, "first");
  Stamped(&segmenter, true, 1.0, 3.0, "first");
  Stamped(&segmenter, true, 1.5, 3.0, "second");
  Stamped(&segmenter, false, 1.5, 3.0, "first");
  Stamped(&segmenter, true, 1.5, 3.0, "second");
  Stamped(&segmenter, false, 2.5, 3.0, "second");
  Stamped(&segmenter, false, 2.5, 3.0, "second");
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 2U);
  ExpectRising(episodes[0], 1.0, 50);
  ExpectRising(episodes[1], 1.5, 100);
  EXPECT_FALSE(segmenter.IsOpen());
}

TEST(EpisodeSegmenter, IgnoresAStartWhileOpenAndAStopWithoutStart) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 0.5);
  Unstamped(&segmenter, false, 0.5);
  Feed(&segmenter, Rising, 0.5, 1.0);
  Unstamped(&segmenter, true, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.5);
  Unstamped(&segmenter, true, 1.5);
  Feed(&segmenter, Rising, 1.5, 2.0);
  Unstamped(&segmenter, false, 2.0);
  Unstamped(&segmenter, false, 2.0);
  Feed(&segmenter, Rising, 2.0, 2.2);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 1U);
  ExpectRising(episodes[0], 1.0, 100);
  EXPECT_EQ(segmenter.TakeEdges().size(), 2U);
  EXPECT_EQ(segmenter.repeated_openings(), 1);
}

TEST(EpisodeSegmenter, CommandsOpenAndCloseInEverySegmentation) {
  for (const SegmentationMode mode :
       {SegmentationMode::kTrigger, SegmentationMode::kContact, SegmentationMode::kAction}) {
    SegmentationOptions options = Options();
    options.segmentation = mode;
    EpisodeSegmenter segmenter(options);
    const auto still = [](double) { return 1.0; };
    Feed(&segmenter, still, 0.0, 1.0);
    Edge(&segmenter, true, EdgeSource::kCommand, 1.0, 1.0);
    Feed(&segmenter, still, 1.0, 2.0);
    Edge(&segmenter, false, EdgeSource::kCommand, 2.0, 2.0);
    Feed(&segmenter, still, 2.0, 2.1);
    const std::vector<Episode> episodes = segmenter.TakeEpisodes();
    ASSERT_EQ(episodes.size(), 1U);
    EXPECT_EQ(episodes[0].force.size(), 100);
    EXPECT_EQ(episodes[0].end_reason, EndReason::kTrigger);
  }
}

TEST(EpisodeSegmenter, DropsAndCountsAnEpisodeThatIsTooShort) {
  EpisodeSegmenter segmenter(Options());
  Feed(&segmenter, Rising, 0.0, 1.0);
  Unstamped(&segmenter, true, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.05);
  Unstamped(&segmenter, false, 1.05);
  Feed(&segmenter, Rising, 1.05, 2.0);
  EXPECT_TRUE(segmenter.TakeEpisodes().empty());
  EXPECT_EQ(segmenter.fault_counts()[static_cast<std::size_t>(EpisodeFault::kTooShort)], 1);
}

TEST(EpisodeSegmenter, DropsAndCountsAnEpisodeWithoutASample) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 1.0);
  Unstamped(&segmenter, false, 2.0);
  segmenter.AdvanceTo(Time(3.0));
  EXPECT_TRUE(segmenter.TakeEpisodes().empty());
  EXPECT_EQ(segmenter.fault_counts()[static_cast<std::size_t>(EpisodeFault::kNoSample)], 1);
}

TEST(EpisodeSegmenter, GivesTheOpenEpisodeSoFar) {
  EpisodeSegmenter segmenter(Options());
  EXPECT_FALSE(segmenter.OpenEpisode().has_value());
  Unstamped(&segmenter, true, 1.0);
  EXPECT_FALSE(segmenter.OpenEpisode().has_value());
  Feed(&segmenter, Rising, 1.0, 1.1);
  EXPECT_FALSE(segmenter.OpenEpisode().has_value()) << "shorter than min_duration";
  Feed(&segmenter, Rising, 1.1, 1.51);
  const std::optional<Episode> open = segmenter.OpenEpisode();
  ASSERT_TRUE(open.has_value());
  ExpectRising(*open, 1.0, 50);
  EXPECT_FALSE(open->complete);
  EXPECT_TRUE(segmenter.IsOpen());
  Unstamped(&segmenter, false, 1.51);
  EXPECT_FALSE(segmenter.OpenEpisode().has_value());
}

TEST(EpisodeSegmenter, CarriesTheFrameOfTheSensor) {
  EpisodeSegmenter segmenter(Options());
  segmenter.set_frame_id("flange");
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 1.0);
  segmenter.Finish(Time(1.0));
  ASSERT_TRUE(segmenter.HasNews());
  EXPECT_EQ(segmenter.TakeEpisodes().front().frame_id, "flange");
}

TEST(EpisodeSegmenter, RefusesOptionsAndNamesEveryFault) {
  SegmentationOptions options;
  options.sample_period = 0.0;
  options.contact_on = 1.0;
  options.edge_wait = 2.0;
  try {
    EpisodeSegmenter segmenter(options);
    FAIL() << "faulty options were accepted";
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("sample_period must be in [0.0001, 1] s, but is 0"), std::string::npos) << message;
    EXPECT_NE(message.find("contact_on must be above contact_off, at most 1e6 N, but is 1"), std::string::npos)
        << message;
    EXPECT_NE(message.find("edge_wait must be in [0, 1] s, but is 2"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace contact_shapelets::core
