#include "core/stream/sample_clock.h"

#include <gtest/gtest.h>

#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

using Verdict = SampleTime::Verdict;

constexpr Nanoseconds kMillisecond = 1'000'000;
constexpr Nanoseconds kSecond = 1'000'000'000;
/// Somewhere today, where a double has no nanoseconds.
constexpr Nanoseconds kStart = 1'700'000'000 * kSecond + 1;

/// Resolves `count` samples 10 ms apart from `stamp` and `arrival` on; all must be accepted.
void Play(SampleClock* clock, Nanoseconds stamp, Nanoseconds arrival, int count) {
  for (int index = 0; index < count; ++index) {
    const SampleTime sample =
        clock->Resolve(stamp == 0 ? 0 : stamp + index * 10 * kMillisecond, arrival + index * 10 * kMillisecond);
    ASSERT_EQ(sample.verdict, Verdict::kAccepted) << "sample " << index;
  }
}

TEST(SampleClock, TakesStampsToTheNanosecondWhateverTheJitterOfArrivals) {
  SampleClock clock;
  const Nanoseconds delays[] = {3 * kMillisecond, 40 * kMillisecond, 31 * kMillisecond, kMillisecond, 2 * kMillisecond};
  for (int index = 0; index < 5; ++index) {
    const Nanoseconds stamp = kStart + index * 10 * kMillisecond;
    const SampleTime sample = clock.Resolve(stamp, stamp + delays[index]);
    EXPECT_EQ(sample.verdict, Verdict::kAccepted);
    EXPECT_EQ(sample.time, stamp);
  }
  EXPECT_EQ(clock.offset(), kMillisecond);
  EXPECT_EQ(clock.zero_stamps(), 0);
  EXPECT_EQ(clock.wrong_stamps(), 0);
}

TEST(SampleClock, TakesTheArrivalWithoutStamps) {
  SampleClock clock;
  EXPECT_EQ(clock.Resolve(0, kStart).time, kStart);
  EXPECT_EQ(clock.Resolve(0, kStart + 7).time, kStart + 7);
  EXPECT_EQ(clock.zero_stamps(), 2);
  EXPECT_EQ(clock.FromArrival(kStart + 9), kStart + 9);
}

TEST(SampleClock, PlacesAZeroStampAmongTheOthersWithoutLosingTheNext) {
  SampleClock clock;
  const Nanoseconds latency = 100 * kMillisecond;
  Play(&clock, kStart, kStart + latency, 10);
  const SampleTime zero = clock.Resolve(0, kStart + 100 * kMillisecond + latency);
  EXPECT_EQ(zero.verdict, Verdict::kAccepted);
  EXPECT_EQ(zero.time, kStart + 100 * kMillisecond);
  Play(&clock, kStart + 110 * kMillisecond, kStart + 110 * kMillisecond + latency, 10);
}

TEST(SampleClock, MovesToTheClockOfTheStampsWhereTheFirstSamplesHadNone) {
  SampleClock clock;
  Play(&clock, 0, kStart, 3);
  const Nanoseconds behind = 3600 * kSecond;
  clock.Resolve(kStart + 30 * kMillisecond - behind, kStart + 30 * kMillisecond);
  const SampleTime sample = clock.Resolve(kStart + 40 * kMillisecond - behind, kStart + 40 * kMillisecond);
  EXPECT_EQ(sample.verdict, Verdict::kJumpedBack);
  EXPECT_EQ(sample.time, kStart + 40 * kMillisecond - behind);
  Play(&clock, kStart + 50 * kMillisecond - behind, kStart + 50 * kMillisecond, 100);
}

TEST(SampleClock, KeepsTheStampsClockWhereItIsHoursOff) {
  SampleClock clock;
  const Nanoseconds ahead = 3600 * kSecond;
  Play(&clock, kStart + ahead, kStart, 50);
  EXPECT_EQ(clock.offset(), -ahead);
  EXPECT_EQ(clock.FromArrival(kStart + kSecond), kStart + ahead + kSecond);
}

TEST(SampleClock, TreatsLessThanHalfASecondAsLatency) {
  SampleClock clock;
  Play(&clock, kStart, kStart + 400 * kMillisecond, 3);
  EXPECT_EQ(clock.FromArrival(kStart + kSecond), kStart + kSecond);
}

TEST(SampleClock, DropsASampleThatComesTwice) {
  SampleClock clock;
  clock.Resolve(kStart, kStart);
  EXPECT_EQ(clock.Resolve(kStart, kStart + kMillisecond).verdict, Verdict::kOutOfOrder);
  EXPECT_EQ(clock.Resolve(kStart + 10, kStart + 10 * kMillisecond).verdict, Verdict::kAccepted);
}

TEST(SampleClock, GoesByArrivalWhereTheStampStandsStill) {
  SampleClock clock;
  clock.Resolve(kStart, kStart);
  int accepted = 0;
  for (int index = 1; index <= 1000; ++index) {
    const SampleTime sample = clock.Resolve(kStart, kStart + index * 10 * kMillisecond);
    accepted += sample.verdict == Verdict::kAccepted ? 1 : 0;
  }
  EXPECT_EQ(accepted, 950);  // the first half second passes for repetitions
  EXPECT_EQ(clock.wrong_stamps(), 950);
}

TEST(SampleClock, PlacesAStampThatRanBackwardByItsArrival) {
  SampleClock clock;
  Play(&clock, kStart, kStart + kMillisecond, 10);
  const SampleTime late = clock.Resolve(kStart + 50 * kMillisecond, kStart + 101 * kMillisecond);
  EXPECT_EQ(late.verdict, Verdict::kAccepted);
  EXPECT_EQ(late.time, kStart + 100 * kMillisecond);
  EXPECT_EQ(clock.wrong_stamps(), 1);
  Play(&clock, kStart + 110 * kMillisecond, kStart + 111 * kMillisecond, 10);
}

TEST(SampleClock, DropsASampleThatIsNotLaterByStampNorByArrival) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  EXPECT_EQ(clock.Resolve(kStart + 50 * kMillisecond, kStart + 90 * kMillisecond).verdict, Verdict::kOutOfOrder);
}

TEST(SampleClock, DoesNotTakeMessagesThatOvertookEachOtherForANewClock) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  for (const int position : {15, 11, 12, 13, 14, 16, 17}) {
    const SampleTime sample = clock.Resolve(kStart + position * 10 * kMillisecond, kStart + 180 * kMillisecond);
    EXPECT_NE(sample.verdict, Verdict::kJumpedBack);
  }
}

TEST(SampleClock, LosesNothingToOneStampThatLeapsAhead) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  const SampleTime leap = clock.Resolve(kStart + 1000 * kSecond, kStart + 100 * kMillisecond);
  EXPECT_EQ(leap.verdict, Verdict::kAccepted);
  EXPECT_EQ(leap.time, kStart + 100 * kMillisecond);
  EXPECT_EQ(clock.wrong_stamps(), 1);
  Play(&clock, kStart + 110 * kMillisecond, kStart + 110 * kMillisecond, 100);
}

TEST(SampleClock, RecoversFromAWrongFirstStamp) {
  SampleClock clock;
  clock.Resolve(kStart + 1000 * kSecond, kStart);
  clock.Resolve(kStart + 10 * kMillisecond, kStart + 10 * kMillisecond);
  EXPECT_EQ(clock.Resolve(kStart + 20 * kMillisecond, kStart + 20 * kMillisecond).verdict, Verdict::kJumpedBack);
  Play(&clock, kStart + 30 * kMillisecond, kStart + 30 * kMillisecond, 100);
  EXPECT_EQ(clock.offset(), 0);
}

TEST(SampleClock, FollowsAClockThatWasSetForward) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  Play(&clock, kStart + 10 * kSecond, kStart + 100 * kMillisecond, 10);
  EXPECT_EQ(clock.Resolve(kStart + 11 * kSecond, kStart + 1100 * kMillisecond).time, kStart + 11 * kSecond);
  EXPECT_EQ(clock.wrong_stamps(), 1);
}

TEST(SampleClock, FollowsAClockThatWasSetBack) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  EXPECT_EQ(clock.Resolve(kStart - 10 * kSecond, kStart + 100 * kMillisecond).verdict, Verdict::kAccepted);
  const SampleTime second = clock.Resolve(kStart - 9990 * kMillisecond, kStart + 110 * kMillisecond);
  EXPECT_EQ(second.verdict, Verdict::kJumpedBack);
  EXPECT_EQ(second.time, kStart - 9990 * kMillisecond);
  Play(&clock, kStart - 9980 * kMillisecond, kStart + 120 * kMillisecond, 2000);
}

TEST(SampleClock, StartsAnewWhereAReplayLoops) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 200);
  const SampleTime sample = clock.Resolve(kStart, kStart);
  EXPECT_EQ(sample.verdict, Verdict::kJumpedBack);
  EXPECT_EQ(sample.time, kStart);
  Play(&clock, kStart + 10 * kMillisecond, kStart + 10 * kMillisecond, 100);
}

TEST(SampleClock, StartsAnewWhereAReplayLoopsWithoutStamps) {
  SampleClock clock;
  Play(&clock, 0, kStart, 200);
  EXPECT_EQ(clock.Resolve(0, kStart).verdict, Verdict::kJumpedBack);
}

TEST(SampleClock, TakesABurstAfterAStallByItsStamps) {
  SampleClock clock;
  Play(&clock, kStart, kStart, 10);
  const Nanoseconds burst = kStart + 3 * kSecond;
  // The sender's queue held only the last second.
  for (int index = 200; index < 300; ++index) {
    const Nanoseconds stamp = kStart + index * 10 * kMillisecond;
    EXPECT_EQ(clock.Resolve(stamp, burst).time, stamp);
  }
  EXPECT_EQ(clock.wrong_stamps(), 0);
}

}  // namespace
}  // namespace contact_shapelets::core
