#include "ros/messages/arrival_clock.h"

#include <gtest/gtest.h>

#include "contact_shapelets/core/wrench_stream.h"

namespace contact_shapelets {
namespace {

using core::FromSeconds;
using core::Nanoseconds;

constexpr double kSystem = 1.7e9;

/// A machine whose system clock is `ahead` [s] of where it was at the start, `time` [s] after that.
ClockReading Reading(double time, double ahead = 0.0) {
  return {FromSeconds(kSystem + time + ahead), FromSeconds(50.0 + time)};
}

TEST(ArrivalClock, GivesTheReceiptWhileNobodySetsTheSystemClock) {
  ArrivalClock clock;
  clock.Look(Reading(0.0));
  clock.Look(Reading(1.0));
  EXPECT_EQ(clock.Of(FromSeconds(kSystem + 1.003), Reading(1.004)), FromSeconds(kSystem + 1.003));
  EXPECT_EQ(clock.Of(FromSeconds(kSystem + 0.2), Reading(1.004)), FromSeconds(kSystem + 0.2)) << "in the batch before";
  EXPECT_EQ(clock.Now(Reading(1.004)), FromSeconds(kSystem + 1.004));
}

TEST(ArrivalClock, AMessageAcrossASettingOfTheClockIsOffByABatchAtMost) {
  for (const double ahead : {-3600.0, -0.5, 0.5, 3600.0}) {
    ArrivalClock clock;
    clock.Look(Reading(0.0));
    clock.Look(Reading(1.000));
    clock.Look(Reading(1.004));
    const Nanoseconds arrival = clock.Of(FromSeconds(kSystem + 1.005), Reading(1.006, ahead));
    EXPECT_GE(arrival, FromSeconds(kSystem + 1.000)) << ahead;
    EXPECT_LE(arrival, FromSeconds(kSystem + 1.006)) << ahead;
  }
}

/// A stream at 1 kHz with a push from 2 s to 4 s. The system clock is set by `ahead` in the middle of the push.
core::Episode PushWhileTheClockIsSet(double ahead) {
  core::WrenchStream stream{core::SegmentationOptions()};
  ArrivalClock clock;
  for (int step = 0; step < 6000; ++step) {
    const double time = 0.001 * step;
    const double set = time > 3.0 ? ahead : 0.0;
    if (step % 4 == 0) clock.Look(Reading(time, set));
    const Nanoseconds receipt = FromSeconds(kSystem + time + set);
    const Nanoseconds arrival = clock.Of(receipt, Reading(time + 0.001, set));
    if (step == 2000 || step == 4000) stream.AddUnstampedEdge(step == 2000, arrival);
    // The driver runs on another machine.
    stream.AddWrench(FromSeconds(1000.0 + time), arrival,
                     {0.001 * (step % 2), 0.0, time > 2.2 && time < 3.8 ? 9.0 : 0.0});
  }
  EXPECT_TRUE(core::FindingsOf(stream.Summary()).size() == 1U) << "the offset of the driver's clock, and no more";
  const std::vector<core::Episode> episodes = stream.TakeEpisodes();
  EXPECT_EQ(episodes.size(), 1U);
  return episodes.empty() ? core::Episode() : episodes.front();
}

TEST(ArrivalClock, ASettingByMoreThanTheStreamTimeoutDoesNotCutAnEpisode) {
  for (const double ahead : {-3600.0, -5.0, 0.0, 5.0, 3600.0}) {
    const core::Episode episode = PushWhileTheClockIsSet(ahead);
    EXPECT_TRUE(episode.complete) << ahead;
    EXPECT_EQ(episode.end_reason, core::EndReason::kTrigger) << ahead;
    EXPECT_NEAR(episode.duration(), 2.0, 0.011) << ahead;
  }
}

}  // namespace
}  // namespace contact_shapelets
