// Segmentation of faulty streams, the tare, and contact segmentation.
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/stream/episode_segmenter.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

SegmentationOptions Options(TareSource tare = TareSource::kService) {
  SegmentationOptions options;
  options.tare = tare;
  return options;
}

void Unstamped(EpisodeSegmenter* segmenter, bool open, double now) {
  segmenter->AddEdge({{open, Time(now), EdgeSource::kUnstamped, "", Time(now)}, Time(now), Time(now), false, 0},
                     Time(now));
}

/// Returns the only episode of `segmenter`.
Episode Only(EpisodeSegmenter* segmenter) {
  const std::vector<Episode> episodes = segmenter->TakeEpisodes();
  EXPECT_EQ(episodes.size(), 1U);
  return episodes.empty() ? Episode() : episodes.front();
}

double Rising(double time) { return 10.0 * time; }

/// Returns a bias of 3 N, plus 12 N from 2 s to 3 s.
double Push(double time) { return time >= 2.0 && time < 3.0 ? 15.0 : 3.0; }

TEST(Tare, OfTheEpisodeStartIsTheMeanOfItsFirstPart) {
  EpisodeSegmenter segmenter(Options(TareSource::kEpisodeStart));
  const auto signal = [](double time) { return time < 1.0 ? 50.0 : Push(time); };
  Feed(&segmenter, signal, 0.0, 1.0);
  Unstamped(&segmenter, true, 1.0);
  Feed(&segmenter, signal, 1.0, 4.0);
  Unstamped(&segmenter, false, 4.0);
  Feed(&segmenter, signal, 4.0, 4.1);
  const Episode episode = Only(&segmenter);
  EXPECT_NEAR(episode.force[50], 0.0, 1e-5);
  EXPECT_NEAR(episode.force[150], 12.0, 1e-5);
}

TEST(Tare, OfTheFreeAirIsTheMeanOfTheTimeBeforeTheEpisode) {
  EpisodeSegmenter segmenter(Options(TareSource::kFreeAir));
  Feed(&segmenter, Push, 0.0, 1.995);
  Unstamped(&segmenter, true, 1.995);
  Feed(&segmenter, Push, 2.0, 3.0);
  Unstamped(&segmenter, false, 2.99);
  Feed(&segmenter, Push, 3.0, 3.1);
  EXPECT_NEAR(Only(&segmenter).force[50], 12.0, 1e-5);
}

TEST(Tare, OfTheFreeAirFallsBackToTheEpisodeStartWithoutSamplesBefore) {
  EpisodeSegmenter segmenter(Options(TareSource::kFreeAir));
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Push, 0.5, 3.0);
  Unstamped(&segmenter, false, 3.0);
  Feed(&segmenter, Push, 3.0, 3.1);
  EXPECT_NEAR(Only(&segmenter).force[250], 12.0, 1e-5);
}

TEST(Tare, OfTheServiceIsWhatWasMeasuredLastAndZeroBefore) {
  EpisodeSegmenter segmenter(Options());
  EXPECT_THROW(segmenter.MeasureTare(), std::runtime_error);
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Push, 0.0, 0.5);
  Unstamped(&segmenter, false, 0.5);
  Feed(&segmenter, Push, 0.5, 1.0);
  EXPECT_NEAR(Only(&segmenter).force[10], 3.0, 1e-5);
  EXPECT_EQ(segmenter.fault_counts()[static_cast<std::size_t>(EpisodeFault::kNotTared)], 1);
  const Eigen::Vector3d tare = segmenter.MeasureTare();
  EXPECT_TRUE(tare.isApprox(AlongZ(3.0), 1e-4));
  segmenter.set_tare(tare);
  Unstamped(&segmenter, true, 1.0);
  Feed(&segmenter, Push, 1.0, 3.0);
  Unstamped(&segmenter, false, 3.0);
  Feed(&segmenter, Push, 3.0, 3.1);
  EXPECT_NEAR(Only(&segmenter).force[150], 12.0, 1e-5);
}

TEST(Tare, IsSubtractedAsAVectorBeforeTheMagnitude) {
  EpisodeSegmenter segmenter(Options(TareSource::kEpisodeStart));
  Unstamped(&segmenter, true, 0.0);
  for (int index = 0; index < 110; ++index) {
    const Eigen::Vector3d force = index < 50 ? Eigen::Vector3d(4.0, 0.0, 0.0) : Eigen::Vector3d(0.0, 3.0, 0.0);
    segmenter.AddSample({Time(0.01 * index), force + 1e-6 * Noisy(0.0, index)}, Time(0.01 * index));
  }
  Unstamped(&segmenter, false, 1.0);
  EXPECT_NEAR(Only(&segmenter).force[80], 5.0, 1e-5);
}

TEST(EpisodeLimits, AGapWithinAnEpisodeMakesItIncomplete) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 0.5);
  Feed(&segmenter, Rising, 0.8, 1.0);
  Unstamped(&segmenter, false, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.1);
  const Episode episode = Only(&segmenter);
  EXPECT_FALSE(episode.complete);
  EXPECT_EQ(episode.end_reason, EndReason::kTrigger);
  EXPECT_EQ(episode.force.size(), 100);
}

TEST(EpisodeLimits, AGapShorterThanMaxGapDoesNot) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 0.5);
  Feed(&segmenter, Rising, 0.68, 1.0);
  Unstamped(&segmenter, false, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.1);
  EXPECT_TRUE(Only(&segmenter).complete);
}

TEST(EpisodeLimits, MissingSamplesAtItsBeginningMakeItIncomplete) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.4, 1.0);
  Unstamped(&segmenter, false, 1.0);
  Feed(&segmenter, Rising, 1.0, 1.1);
  EXPECT_FALSE(Only(&segmenter).complete);
}

TEST(EpisodeLimits, AStreamThatStopsClosesTheEpisodeAtItsLastSample) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 1.01);
  segmenter.AdvanceTo(Time(1.9));
  EXPECT_TRUE(segmenter.IsOpen());
  segmenter.AdvanceTo(Time(2.2));
  EXPECT_FALSE(segmenter.IsOpen());
  const Episode episode = Only(&segmenter);
  EXPECT_EQ(episode.end_reason, EndReason::kStream);
  EXPECT_FALSE(episode.complete);
  EXPECT_EQ(episode.force.size(), 100);
}

TEST(EpisodeLimits, AStreamThatResumesAfterItsTimeoutDoesNotBelongToTheEpisode) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 1.01);
  Feed(&segmenter, Rising, 5.0, 6.0);
  EXPECT_EQ(Only(&segmenter).force.size(), 100);
}

TEST(EpisodeLimits, AnEpisodeThatIsTooLongIsCutAndIncomplete) {
  SegmentationOptions options = Options();
  options.max_duration = 2.0;
  EpisodeSegmenter segmenter(options);
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 5.0);
  Unstamped(&segmenter, false, 5.0);
  const Episode episode = Only(&segmenter);
  EXPECT_EQ(episode.end_reason, EndReason::kTimeout);
  EXPECT_EQ(episode.force.size(), 200);
  EXPECT_FALSE(episode.complete);
}

TEST(EpisodeLimits, TheEndOfTheInputClosesWhatIsOpen) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 1.01);
  segmenter.Finish(Time(102.0));
  EXPECT_EQ(Only(&segmenter).end_reason, EndReason::kStream);
  segmenter.Finish(Time(102.0));
  EXPECT_FALSE(segmenter.TakeEpisodes().size());
}

TEST(EpisodeLimits, TheEndOfTheInputFinishesWhatWaits) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  Feed(&segmenter, Rising, 0.0, 1.0);
  Unstamped(&segmenter, false, 1.0);
  segmenter.Finish(Time(102.0));
  const Episode episode = Only(&segmenter);
  EXPECT_EQ(episode.end_reason, EndReason::kTrigger);
  EXPECT_TRUE(episode.complete);
}

TEST(EpisodeLimits, ARestartEndsTheOpenEpisodeAndForgetsOldSamples) {
  EpisodeSegmenter segmenter(Options(TareSource::kFreeAir));
  const auto high = [](double) { return 40.0; };
  Feed(&segmenter, high, 99.0, 100.0);
  Unstamped(&segmenter, true, 100.0);
  Feed(&segmenter, high, 100.0, 101.01);
  segmenter.Restart(Time(102.0));
  EXPECT_EQ(Only(&segmenter).end_reason, EndReason::kStream);
  // The second round has the times of the first again.
  Feed(&segmenter, Push, 0.0, 1.0);
  Unstamped(&segmenter, true, 1.0);
  Feed(&segmenter, Push, 1.0, 3.0);
  Unstamped(&segmenter, false, 3.0);
  Feed(&segmenter, Push, 3.0, 3.1);
  const Episode episode = Only(&segmenter);
  EXPECT_TRUE(episode.complete);
  EXPECT_EQ(episode.start, Time(1.0));
  EXPECT_NEAR(episode.force[150], 12.0, 1e-5);
}

TEST(EpisodeLimits, KeepsAnEpisodeOfTheLongestDurationWhole) {
  SegmentationOptions options = Options();
  options.max_duration = 20.0;
  EpisodeSegmenter segmenter(options);
  Feed(&segmenter, Rising, 0.0, 30.0, 1000.0);
  Unstamped(&segmenter, true, 30.0);
  Feed(&segmenter, Rising, 30.0, 49.9, 1000.0);
  Unstamped(&segmenter, false, 49.9);
  Feed(&segmenter, Rising, 49.9, 50.0, 1000.0);
  const Episode episode = Only(&segmenter);
  ASSERT_EQ(episode.force.size(), 1990);
  EXPECT_TRUE(episode.complete);
  EXPECT_NEAR(episode.force[0], Rising(30.005), 1e-3);
  EXPECT_NEAR(episode.force[1989], Rising(49.895), 1e-3);
}

/// Cuts one second of a rising force to which the sensor applies `change` from 0.4 s on.
Episode Held(double seconds, bool zeros) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  for (int index = 0; index <= 210; ++index) {
    const double time = 0.005 * index;
    const bool held = time >= 0.4 && time < 0.4 + seconds;
    const double force = held ? (zeros ? 0.0 : Rising(0.4)) : Rising(time) + 1.0;
    segmenter.AddSample({Time(time), AlongZ(force)}, Time(time));
  }
  Unstamped(&segmenter, false, 1.0);
  return Only(&segmenter);
}

TEST(EpisodeLimits, ASensorThatHoldsItsValueMakesTheEpisodeIncomplete) {
  EXPECT_FALSE(Held(0.3, false).complete);
  EXPECT_TRUE(Held(0.1, false).complete);
}

TEST(EpisodeLimits, AValueThatRecursIsNotFrozen) {
  EpisodeSegmenter segmenter(Options());
  Unstamped(&segmenter, true, 0.0);
  // A sensor with a dead band of 3 N: zeros at both ends and a push between them, in steps of 1 N.
  for (int index = 0; index <= 210; ++index) {
    const double push = 12.0 * std::sin(M_PI * index / 200.0);
    segmenter.AddSample({Time(0.005 * index), AlongZ(push < 3.0 ? 0.0 : std::round(push))}, Time(0.005 * index));
  }
  Unstamped(&segmenter, false, 1.0);
  EXPECT_TRUE(Only(&segmenter).complete);
}

TEST(EpisodeLimits, AnUnstampedOpeningOutOfTheBlueMeansALostClosing) {
  for (const double again : {1.0, 3.0}) {
    EpisodeSegmenter segmenter(Options());
    Unstamped(&segmenter, true, 0.0);
    Feed(&segmenter, Rising, 0.0, again);
    Unstamped(&segmenter, true, again);
    Feed(&segmenter, Rising, again, 4.1);
    Unstamped(&segmenter, false, 4.0);
    EXPECT_EQ(Only(&segmenter).complete, again < 2.0) << again;
  }
}

TEST(EpisodeLimits, ASensorThatGivesExactZerosMakesTheEpisodeIncomplete) {
  EXPECT_FALSE(Held(0.15, true).complete);
  EXPECT_TRUE(Held(0.05, true).complete);
}

TEST(EpisodeLimits, SamplesWithWrongStampsAmongOthersMakeTheEpisodeIncomplete) {
  for (const int wrong : {2, 3}) {
    EpisodeSegmenter segmenter(Options());
    Unstamped(&segmenter, true, 0.0);
    for (int index = 0; index <= 110; ++index) {
      segmenter.AddSample({Time(0.01 * index), AlongZ(index), index >= 50 && index < 50 + wrong}, Time(0.01 * index));
    }
    Unstamped(&segmenter, false, 1.0);
    EXPECT_EQ(Only(&segmenter).complete, wrong == 2);
  }
}

SegmentationOptions ContactOptions() {
  SegmentationOptions options;
  options.segmentation = SegmentationMode::kContact;
  return options;
}

TEST(ContactSegmentation, CutsFromThePreTriggerToTheEndOfTheHoldOff) {
  EpisodeSegmenter segmenter(ContactOptions());
  Feed(&segmenter, Push, 0.0, 4.0);
  const Episode episode = Only(&segmenter);
  EXPECT_EQ(episode.start, Time(1.5));
  EXPECT_EQ(episode.end_reason, EndReason::kContact);
  EXPECT_TRUE(episode.complete);
  EXPECT_EQ(episode.force.size(), 170);
  EXPECT_NEAR(episode.force[10], 0.0, 1e-4);
  EXPECT_NEAR(episode.force[100], 12.0, 1e-4);
}

TEST(ContactSegmentation, IgnoresTriggers) {
  EpisodeSegmenter segmenter(ContactOptions());
  Feed(&segmenter, Push, 0.0, 1.0);
  Unstamped(&segmenter, true, 1.0);
  EXPECT_FALSE(segmenter.IsOpen());
  segmenter.AddEdge({{true, Time(1.0), EdgeSource::kStamped, "", 0}, Time(1.0), Time(1.0), false, 0}, Time(1.0));
  EXPECT_FALSE(segmenter.IsOpen());
}

TEST(ContactSegmentation, ContactsCloseToEachOtherShareNoSample) {
  EpisodeSegmenter segmenter(ContactOptions());
  const auto twice = [](double time) {
    return (time >= 2.0 && time < 3.0) || (time >= 3.35 && time < 4.0) ? 15.0 : 3.0;
  };
  Feed(&segmenter, twice, 0.0, 5.0);
  const std::vector<Episode> episodes = segmenter.TakeEpisodes();
  ASSERT_EQ(episodes.size(), 2U);
  const Nanoseconds end = episodes[0].start + Time(episodes[0].duration());
  EXPECT_GE(episodes[1].start, end);
  // Its tare is free air. If it began 0.5 s before the contact, its tare would be the force of the first contact.
  EXPECT_NEAR(episodes[1].force.maxCoeff(), 12.0, 1e-4);
}

TEST(ContactSegmentation, ALastingForceGivesOneEpisodeOfTheLongestDuration) {
  SegmentationOptions options = ContactOptions();
  options.max_duration = 2.0;
  EpisodeSegmenter segmenter(options);
  Feed(
      &segmenter, [](double time) { return time >= 2.0 && time < 12.0 ? 15.0 : 3.0; }, 0.0, 20.0);
  EXPECT_EQ(Only(&segmenter).end_reason, EndReason::kTimeout);
}

}  // namespace
}  // namespace contact_shapelets::core
