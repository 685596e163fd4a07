#include "core/stream/contact_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numerics/random.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

using Changes = std::vector<ContactDetector::Change>;

/// contact begins above 8 N for 5 ms and ends below 4 N for 0.2 s, pre-trigger 0.5 s.
SegmentationOptions Options() { return SegmentationOptions(); }

Changes Play(ContactDetector* detector, const Signal& signal, double begin, double end, double rate = 1000.0) {
  Changes changes;
  const auto count = static_cast<int>(std::lround((end - begin) * rate));
  for (int index = 0; index < count; ++index) {
    const double time = begin + index / rate;
    const auto change = detector->AddSample({Time(time), AlongZ(signal(time))}, Time(time));
    if (change) changes.push_back(*change);
  }
  return changes;
}

/// Returns `height` between the two times, else zero.
Signal Pulse(double begin, double end, double height, double bias = 0.0) {
  return [=](double time) { return bias + (time >= begin && time < end ? height : 0.0); };
}

TEST(ContactDetector, BeginsThePreTriggerTimeBeforeTheForceRises) {
  ContactDetector detector(Options());
  const Changes changes = Play(&detector, Pulse(2.0, 3.0, 20.0), 0.0, 2.5);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_TRUE(changes[0].contact);
  EXPECT_EQ(changes[0].time, Time(1.5));
}

TEST(ContactDetector, EndsOnceTheForceWasLowForTheHoldOff) {
  ContactDetector detector(Options());
  const Changes changes = Play(&detector, Pulse(2.0, 3.0, 20.0), 0.0, 4.0);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_FALSE(changes[1].contact);
  EXPECT_EQ(changes[1].time, Time(3.2));
}

TEST(ContactDetector, IgnoresAPeakShorterThanTheHoldOn) {
  ContactDetector detector(Options());
  EXPECT_TRUE(Play(&detector, Pulse(2.0, 2.004, 50.0), 0.0, 3.0).empty());
}

TEST(ContactDetector, BridgesALapseShorterThanTheHoldOff) {
  ContactDetector detector(Options());
  const auto signal = [](double time) { return time > 2.0 && time < 3.0 && (time < 2.4 || time > 2.55) ? 20.0 : 0.0; };
  const Changes changes = Play(&detector, signal, 0.0, 4.0);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_GT(changes[1].time, Time(3.1));
}

TEST(ContactDetector, KeepsContactBetweenTheTwoThresholds) {
  ContactDetector detector(Options());
  const auto signal = [](double time) { return time < 2.0 ? 0.0 : time < 2.1 ? 20.0 : 6.0; };
  EXPECT_EQ(Play(&detector, signal, 0.0, 10.0).size(), 1U);
}

TEST(ContactDetector, NeedsTheUpperThresholdToBegin) {
  ContactDetector detector(Options());
  EXPECT_TRUE(Play(&detector, Pulse(2.0, 3.0, 7.5), 0.0, 4.0).empty());
}

TEST(ContactDetector, MeasuresFromARunningBaseline) {
  ContactDetector detector(Options());
  // A drift of 1 N/s that adds up to far more than the threshold, then a push.
  const auto signal = [](double time) { return 30.0 + time + (time > 20.0 ? 15.0 : 0.0); };
  const Changes changes = Play(&detector, signal, 0.0, 20.5, 200.0);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(1e-9 * static_cast<double>(changes[0].time), 19.5, 0.01);
}

TEST(ContactDetector, DoesNotLearnTheContactForceAsItsBaseline) {
  ContactDetector detector(Options());
  const Changes changes = Play(&detector, Pulse(2.0, 22.0, 20.0, 5.0), 0.0, 23.0);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[1].time, Time(22.2));
}

TEST(ContactDetector, SeesAForceOfAnyDirection) {
  ContactDetector detector(Options());
  EXPECT_EQ(Play(&detector, Pulse(2.0, 3.0, -20.0), 0.0, 4.0).size(), 2U);
}

TEST(ContactDetector, ALastingForceDoesNotTriggerAgainAfterTheEnd) {
  ContactDetector detector(Options());
  const Signal pulse = Pulse(2.0, 10.0, 20.0);
  Play(&detector, pulse, 0.0, 3.0);
  detector.EndContact();
  EXPECT_TRUE(Play(&detector, pulse, 3.0, 9.0).empty());
}

TEST(ContactDetector, LettingGoAfterTheEndIsNoContact) {
  ContactDetector detector(Options());
  const Signal pulse = Pulse(2.0, 5.0, 20.0);
  Play(&detector, pulse, 0.0, 3.0);
  detector.EndContact();
  EXPECT_TRUE(Play(&detector, pulse, 3.0, 9.0).empty());
}

TEST(ContactDetector, TriggersAgainOnceItWasLetGo) {
  ContactDetector detector(Options());
  Play(&detector, Pulse(2.0, 5.0, 20.0), 0.0, 3.0);
  detector.EndContact();
  Play(&detector, Pulse(2.0, 5.0, 20.0), 3.0, 6.0);
  const Changes changes = Play(&detector, Pulse(6.0, 7.0, 20.0), 6.0, 8.0);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].time, Time(5.5));
}

/// Rises from 0 N at `begin` by `slope` [N/s] to `height` [N], holds that for a second, then falls to 0 N.
Signal Slow(double begin, double slope, double height, double bias = 0.0) {
  const double end = begin + height / slope + 1.0;
  return [=](double time) {
    return bias + (time < begin || time >= end ? 0.0 : std::min(height, slope * (time - begin)));
  };
}

TEST(ContactDetector, SeesASlowContactAndItsEnd) {
  for (const double slope : {2.0, 3.0, 6.0, 8.0, 20.0}) {
    ContactDetector detector(Options());
    const Signal slow = Slow(3.0, slope, 60.0);
    const double end = 3.0 + 60.0 / slope + 1.0;
    const Changes changes = Play(&detector, slow, 0.0, end + 3.0, 200.0);
    ASSERT_EQ(changes.size(), 2U) << slope;
    // Within 3 N of the threshold.
    EXPECT_LT(ToSeconds(changes[0].time), 3.0 + 11.0 / slope) << slope;
    EXPECT_NEAR(ToSeconds(changes[1].time), end + 0.2, 0.02) << slope;
    EXPECT_FALSE(changes[1].zero_moved);
  }
}

TEST(ContactDetector, TakesWhatRisesByLessThanDriftForDrift) {
  ContactDetector detector(Options());
  EXPECT_TRUE(Play(
                  &detector, [](double time) { return 1.0 * time; }, 0.0, 60.0, 200.0)
                  .empty());
}

TEST(ContactDetector, FollowsTheFreeAirForceThatAChangeOfPoseMoves) {
  ContactDetector detector(Options());
  const auto pose = [](double time) { return time < 3.0 ? -4.0 : std::min(3.5, -4.0 + 13.0 * (time - 3.0)); };
  EXPECT_TRUE(Play(&detector, pose, 0.0, 6.0, 200.0).empty());
  const auto push = [&](double time) { return pose(time) + (time >= 6.5 && time < 7.5 ? 20.0 : 0.0); };
  EXPECT_EQ(Play(&detector, push, 6.0, 9.0, 200.0).size(), 2U);
}

TEST(ContactDetector, ReadsFreeAirFarFromZero) {
  ContactDetector detector(Options());
  EXPECT_EQ(Play(&detector, Pulse(2.0, 3.0, 20.0, 38.0), 0.0, 5.0).size(), 2U);
}

TEST(ContactDetector, SurvivesASensorThatDoesNotReturnToZero) {
  ContactDetector detector(Options());
  int contacts = 0;
  for (int push = 0; push < 10; ++push) {
    const double begin = 5.0 * push;
    const auto signal = [&](double time) {
      return 3.5 * push + (time > begin + 2.0 ? time < begin + 3.0 ? 20.0 : 3.5 : 0.0);
    };
    for (const auto& change : Play(&detector, signal, begin, begin + 5.0, 200.0)) contacts += change.contact ? 1 : 0;
  }
  EXPECT_EQ(contacts, 10);
}

/// Ten pushes of one second on top of a free-air force, every four seconds from 4 s on.
Signal Pushes(const Signal& free_air) {
  return [free_air](double time) {
    const double phase = std::fmod(time, 4.0);
    return free_air(time) + (time > 4.0 && phase > 1.0 && phase < 2.0 ? 25.0 : 0.0);
  };
}

TEST(ContactDetector, ASensorThatRezeroesCostsOnePushAtMost) {
  for (const double when : {10.0, 13.5}) {
    ContactDetector detector(Options());
    const Signal pushes = Pushes([when](double time) { return time < when ? 0.0 : -34.0; });
    const Changes changes = Play(&detector, pushes, 0.0, 44.0, 200.0);
    int sound = 0;
    int moved = 0;
    for (const auto& change : changes) {
      if (!change.contact) (change.zero_moved ? moved : sound)++;
    }
    EXPECT_GE(sound, 8) << when;
    EXPECT_LE(moved, 1) << when;
  }
}

TEST(ContactDetector, AStreamThatBeginsInContactCostsOnePushAtMost) {
  ContactDetector detector(Options());
  const Signal pushes = Pushes([](double time) { return time < 2.0 ? 60.0 : 0.0; });
  const Changes changes = Play(&detector, pushes, 0.0, 44.0, 200.0);
  int sound = 0;
  for (const auto& change : changes) sound += !change.contact && !change.zero_moved ? 1 : 0;
  EXPECT_GE(sound, 9);
}

TEST(ContactDetector, AStreamThatBeginsInAMovingContactWaitsForFreeAir) {
  ContactDetector detector(Options());
  const Signal pushes = Pushes([](double time) { return time < 1.0 ? 30.0 + 20.0 * std::sin(9.0 * time) : 0.0; });
  const Changes changes = Play(&detector, pushes, 0.0, 44.0, 200.0);
  EXPECT_EQ(changes.size(), 20U);
}

TEST(ContactDetector, FindsEachPushInNoiseFarBelowItsThreshold) {
  for (const double rate : {33.0, 200.0}) {
    Random random(1);
    const auto signal = [&random](double time) {
      const double phase = std::fmod(time, 5.0);
      return (time > 5.0 && phase < 1.5 ? 25.0 : 0.0) + random.Normal();
    };
    ContactDetector detector(Options());
    const Changes changes = Play(&detector, signal, 0.0, 54.0, rate);
    const auto contacts =
        std::count_if(changes.begin(), changes.end(), [](const auto& change) { return change.contact; });
    EXPECT_EQ(contacts, 10) << rate;
  }
}

TEST(ContactDetector, WorksAtALowRate) {
  ContactDetector detector(Options());
  EXPECT_EQ(Play(&detector, Pulse(2.0, 3.0, 20.0), 0.0, 4.0, 30.0).size(), 2U);
}

}  // namespace
}  // namespace contact_shapelets::core
