#include "core/stream/stream_clock.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/numerics/random.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

using Verdict = SampleTime::Verdict;

constexpr Nanoseconds kMillisecond = 1'000'000;
constexpr Nanoseconds kSecond = 1'000'000'000;
/// A time today, at which a double cannot hold nanoseconds.
constexpr Nanoseconds kStart = 1'700'000'000 * kSecond + 1;

/// Resolves `count` samples 10 ms apart from `stamp` and `arrival` on. Expects that all are accepted.
void Play(StreamClock* clock, Nanoseconds stamp, Nanoseconds arrival, int count) {
  for (int index = 0; index < count; ++index) {
    const SampleTime sample =
        clock->Resolve(stamp == 0 ? 0 : stamp + index * 10 * kMillisecond, arrival + index * 10 * kMillisecond);
    ASSERT_EQ(sample.verdict, Verdict::kAccepted) << "sample " << index;
  }
}

/// Resolves samples 10 ms apart from `arrival` on by a clock that is `offset` behind. Returns how many are accepted
/// before the stream starts anew.
int PlayUntilRestart(StreamClock* clock, Nanoseconds arrival, Nanoseconds offset) {
  for (int index = 0; index < 100; ++index) {
    const Nanoseconds now = arrival + index * 10 * kMillisecond;
    if (clock->Resolve(now - offset, now).verdict == Verdict::kRestarted) return index;
  }
  return -1;
}

TEST(StreamClock, TakesStampsToTheNanosecondWhateverTheJitterOfArrivals) {
  StreamClock clock;
  const Nanoseconds delays[] = {3 * kMillisecond, 40 * kMillisecond, 31 * kMillisecond, kMillisecond, 2 * kMillisecond};
  for (int index = 0; index < 5; ++index) {
    const Nanoseconds stamp = kStart + index * 10 * kMillisecond;
    const SampleTime sample = clock.Resolve(stamp, stamp + delays[index]);
    EXPECT_EQ(sample.verdict, Verdict::kAccepted);
    EXPECT_EQ(sample.time, stamp);
    EXPECT_TRUE(sample.by_stamp);
  }
  EXPECT_EQ(clock.offset(), kMillisecond);
  EXPECT_EQ(clock.zero_stamps(), 0);
  EXPECT_EQ(clock.wrong_stamps(), 0);
}

TEST(StreamClock, TakesTheArrivalWithoutStamps) {
  StreamClock clock;
  EXPECT_EQ(clock.Resolve(0, kStart).time, kStart);
  EXPECT_EQ(clock.Resolve(0, kStart + 7).time, kStart + 7);
  EXPECT_EQ(clock.zero_stamps(), 2);
  EXPECT_EQ(clock.FromArrival(kStart + 9), kStart + 9);
}

TEST(StreamClock, PlacesAZeroStampAmongTheOthersWithoutLosingTheNext) {
  StreamClock clock;
  const Nanoseconds latency = 100 * kMillisecond;
  Play(&clock, kStart, kStart + latency, 10);
  const SampleTime zero = clock.Resolve(0, kStart + 100 * kMillisecond + latency);
  EXPECT_EQ(zero.verdict, Verdict::kAccepted);
  EXPECT_EQ(zero.time, kStart + 100 * kMillisecond);
  Play(&clock, kStart + 110 * kMillisecond, kStart + 110 * kMillisecond + latency, 10);
}

TEST(StreamClock, MovesToTheClockOfTheStampsWhereTheFirstSamplesHadNone) {
  StreamClock clock;
  Play(&clock, 0, kStart, 3);
  EXPECT_EQ(PlayUntilRestart(&clock, kStart + 30 * kMillisecond, 3600 * kSecond), 4);
  EXPECT_EQ(clock.offset(), 3600 * kSecond);
}

TEST(StreamClock, PlacesArrivalsByTheOffsetOfTheClocksHoweverSmall) {
  for (const Nanoseconds ahead : {3600 * kSecond, 450 * kMillisecond, 20 * kMillisecond, -450 * kMillisecond}) {
    StreamClock clock;
    Play(&clock, kStart + ahead, kStart, 50);
    EXPECT_EQ(clock.offset(), -ahead);
    EXPECT_EQ(clock.FromArrival(kStart + kSecond), kStart + ahead + kSecond);
  }
}

TEST(StreamClock, FollowsDriftOfEitherSign) {
  for (const double drift : {100e-6, -100e-6, 2e-3, -2e-3}) {
    StreamClock clock;
    Random random(1);
    double worst = 0.0;
    for (int index = 0; index < 60000; ++index) {
      const Nanoseconds arrival = kStart + index * 10 * kMillisecond;
      const auto stamp = kStart + static_cast<Nanoseconds>(static_cast<double>(arrival - kStart) * (1.0 + drift));
      clock.Resolve(stamp, arrival + static_cast<Nanoseconds>(random.Uniform(0.0, 4e6)));
      if (index > 100) worst = std::max(worst, std::abs(ToSeconds(clock.FromArrival(arrival) - stamp)));
    }
    EXPECT_LT(worst, 0.005) << drift;
    EXPECT_NEAR(clock.drift(), -drift, 5e-5 + 0.01 * std::abs(drift));
    EXPECT_EQ(clock.wrong_stamps() + clock.stamp_steps() + clock.arrival_steps(), 0);
  }
}

TEST(StreamClock, OneStampAheadMovesNothing) {
  for (const Nanoseconds ahead : {50 * kMillisecond, 400 * kMillisecond, 1000 * kSecond}) {
    StreamClock clock;
    Play(&clock, kStart, kStart, 10);
    const SampleTime leap = clock.Resolve(kStart + 100 * kMillisecond + ahead, kStart + 100 * kMillisecond);
    EXPECT_EQ(leap.verdict, Verdict::kAccepted);
    EXPECT_EQ(leap.time, kStart + 100 * kMillisecond);
    EXPECT_FALSE(leap.by_stamp);
    EXPECT_EQ(clock.wrong_stamps(), 1);
    Play(&clock, kStart + 110 * kMillisecond, kStart + 110 * kMillisecond, 100);
    EXPECT_EQ(clock.offset(), 0);
  }
}

TEST(StreamClock, GoesByArrivalWhereTheStampStandsStill) {
  StreamClock clock;
  clock.Resolve(kStart, kStart);
  for (int index = 1; index <= 1000; ++index) {
    const SampleTime sample = clock.Resolve(kStart, kStart + index * 10 * kMillisecond);
    EXPECT_EQ(sample.time, kStart + index * 10 * kMillisecond);
  }
  EXPECT_EQ(clock.wrong_stamps(), 1000);
}

TEST(StreamClock, PlacesAStampThatRanBackwardByItsArrival) {
  StreamClock clock;
  Play(&clock, kStart, kStart + kMillisecond, 10);
  const SampleTime late = clock.Resolve(kStart + 50 * kMillisecond, kStart + 101 * kMillisecond);
  EXPECT_EQ(late.verdict, Verdict::kAccepted);
  EXPECT_EQ(late.time, kStart + 100 * kMillisecond);
  EXPECT_EQ(clock.wrong_stamps(), 1);
  Play(&clock, kStart + 110 * kMillisecond, kStart + 111 * kMillisecond, 10);
}

TEST(StreamClock, DropsASampleThatIsNotLaterByStampNorByArrival) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 10);
  EXPECT_EQ(clock.Resolve(kStart + 50 * kMillisecond, kStart + 90 * kMillisecond).verdict, Verdict::kOutOfOrder);
}

TEST(StreamClock, DoesNotTakeMessagesThatOvertookEachOtherForANewClock) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 10);
  for (const int position : {18, 11, 12, 13, 14, 15, 16, 17, 19}) {
    const SampleTime sample = clock.Resolve(kStart + position * 10 * kMillisecond, kStart + 190 * kMillisecond);
    EXPECT_NE(sample.verdict, Verdict::kRestarted);
  }
}

TEST(StreamClock, RecoversFromAWrongFirstStamp) {
  for (const Nanoseconds ahead : {400 * kMillisecond, 1000 * kSecond}) {
    StreamClock clock;
    clock.Resolve(kStart + ahead, kStart);
    EXPECT_EQ(PlayUntilRestart(&clock, kStart + 10 * kMillisecond, 0), 4);
    Play(&clock, kStart + 60 * kMillisecond, kStart + 60 * kMillisecond, 100);
    EXPECT_EQ(clock.offset(), 0);
  }
}

TEST(StreamClock, StartsAnewWhereTheDriversClockIsSetEitherWay) {
  for (const Nanoseconds step : {10 * kSecond, 400 * kMillisecond, -400 * kMillisecond, -10 * kSecond}) {
    StreamClock clock;
    Play(&clock, kStart, kStart, 100);
    EXPECT_EQ(PlayUntilRestart(&clock, kStart + kSecond, -step), 4) << step;
    EXPECT_EQ(clock.offset(), -step);
    EXPECT_EQ(clock.wrong_stamps(), 4);
    EXPECT_EQ(clock.stamp_steps(), 1);
    EXPECT_EQ(clock.start_arrival(), kStart + kSecond);
    Play(&clock, kStart + 1050 * kMillisecond + step, kStart + 1050 * kMillisecond, 2000);
  }
}

TEST(StreamClock, FollowsThisMachinesClockWhereThatIsSetForward) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 500);
  const Nanoseconds step = 800 * kMillisecond;
  Play(&clock, kStart + 5 * kSecond, kStart + 5 * kSecond + step, 1);
  EXPECT_TRUE(clock.is_in_doubt());
  Play(&clock, kStart + 5010 * kMillisecond, kStart + 5010 * kMillisecond + step, 105);
  EXPECT_FALSE(clock.is_in_doubt());
  EXPECT_EQ(clock.offset(), step);
  EXPECT_EQ(clock.arrival_steps(), 1);
}

TEST(StreamClock, FollowsThisMachinesClockWhereThatIsSetBack) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 500);
  Play(&clock, kStart + 5 * kSecond, kStart + 4200 * kMillisecond, 100);
  EXPECT_EQ(clock.offset(), -800 * kMillisecond);
  EXPECT_EQ(clock.arrival_steps(), 1);
  EXPECT_EQ(clock.wrong_stamps() + clock.jumps_back(), 0);
}

TEST(StreamClock, FollowsAnArrivalClockThatStallsAndCatchesUp) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 500);
  // 1.2 s of stamps at one arrival, and then the right arrivals again.
  for (int index = 500; index < 620; ++index) {
    EXPECT_EQ(clock.Resolve(kStart + index * 10 * kMillisecond, kStart + 5 * kSecond).verdict, Verdict::kAccepted);
  }
  Play(&clock, kStart + 6200 * kMillisecond, kStart + 6200 * kMillisecond, 105);
  EXPECT_EQ(clock.offset(), 0);
  EXPECT_FALSE(clock.is_in_doubt());
}

TEST(StreamClock, StartsAnewWhereAReplayLoops) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 200);
  const SampleTime sample = clock.Resolve(kStart, kStart);
  EXPECT_EQ(sample.verdict, Verdict::kRestarted);
  EXPECT_EQ(sample.time, kStart);
  EXPECT_EQ(clock.jumps_back(), 1);
  Play(&clock, kStart + 10 * kMillisecond, kStart + 10 * kMillisecond, 100);
}

TEST(StreamClock, StartsAnewWhereAReplayLoopsWithoutStamps) {
  StreamClock clock;
  Play(&clock, 0, kStart, 200);
  EXPECT_EQ(clock.Resolve(0, kStart).verdict, Verdict::kRestarted);
}

TEST(StreamClock, TakesABurstAfterAStallByItsStamps) {
  StreamClock clock;
  Play(&clock, kStart, kStart, 10);
  const Nanoseconds burst = kStart + 3 * kSecond;
  // The sender's queue held only the last second.
  for (int index = 200; index < 300; ++index) {
    const Nanoseconds stamp = kStart + index * 10 * kMillisecond;
    EXPECT_EQ(clock.Resolve(stamp, burst).time, stamp);
  }
  EXPECT_EQ(clock.wrong_stamps(), 0);
  EXPECT_EQ(clock.offset(), 0);
}

}  // namespace
}  // namespace contact_shapelets::core
