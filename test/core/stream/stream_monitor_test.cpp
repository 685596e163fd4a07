#include "core/stream/stream_monitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/numerics/random.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

/// Adds `count` different samples, `interval` [s] apart, the first at `begin` [s].
void Play(StreamMonitor* monitor, double begin, double interval, int count) {
  for (int index = 0; index < count; ++index) {
    monitor->AddSample(Time(begin + index * interval), AlongZ(10.0 + 0.01 * index));
  }
}

std::vector<std::string> Texts(const StreamSummary& summary) {
  std::vector<std::string> texts;
  for (const Finding& finding : FindingsOf(summary)) texts.push_back(finding.text);
  return texts;
}

bool Finds(const StreamSummary& summary, const std::string& words) {
  const std::vector<std::string> findings = Texts(summary);
  return std::any_of(findings.begin(), findings.end(),
                     [&words](const std::string& finding) { return finding.find(words) != std::string::npos; });
}

TEST(StreamMonitor, MeasuresRateRangeAndDurationOfAnEvenStream) {
  StreamMonitor monitor;
  Play(&monitor, 5.0, 0.005, 201);
  const StreamSummary summary = monitor.Summary();
  EXPECT_EQ(summary.samples, 201);
  EXPECT_NEAR(summary.rate, 200.0, 1e-6);
  EXPECT_NEAR(summary.jitter, 0.0, 1e-9);
  EXPECT_NEAR(summary.duration, 1.0, 1e-9);
  EXPECT_NEAR(summary.longest_interval, 0.005, 1e-9);
  EXPECT_DOUBLE_EQ(summary.least_force, 10.0);
  EXPECT_DOUBLE_EQ(summary.greatest_force, 12.0);
  EXPECT_EQ(summary.gaps + summary.repeated, 0);
  EXPECT_TRUE(Texts(summary).empty());
}

TEST(StreamMonitor, HasNoRateWithFewerThanTwoSamples) {
  StreamMonitor monitor;
  EXPECT_EQ(monitor.Summary().rate, 0.0);
  EXPECT_TRUE(Finds(monitor.Summary(), "no usable sample"));
  Play(&monitor, 0.0, 0.01, 1);
  EXPECT_EQ(monitor.Summary().rate, 0.0);
  EXPECT_TRUE(Texts(monitor.Summary()).empty());
}

TEST(StreamMonitor, MeasuresJitterAsTheDeviationOfTheIntervals) {
  StreamMonitor monitor;
  double time = 0.0;
  for (int index = 0; index <= 1000; ++index) {
    monitor.AddSample(Time(time), AlongZ(index));
    time += index % 2 == 0 ? 0.008 : 0.012;
  }
  EXPECT_NEAR(monitor.Summary().rate, 100.0, 1e-6);
  EXPECT_NEAR(monitor.Summary().jitter, 0.002, 1e-9);
  EXPECT_TRUE(Texts(monitor.Summary()).empty());
}

TEST(StreamMonitor, FindsHeavyJitter) {
  Random random(1);
  StreamMonitor monitor;
  double time = 0.0;
  for (int index = 0; index < 1000; ++index) {
    monitor.AddSample(Time(time), AlongZ(index));
    time += index % 4 == 0 ? 0.016 : random.Uniform(0.0005, 0.0015);
  }
  EXPECT_TRUE(Finds(monitor.Summary(), "jitter"));
}

TEST(StreamMonitor, CountsGapsAndTheLongest) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 100);
  Play(&monitor, 1.5, 0.01, 100);
  Play(&monitor, 2.8, 0.01, 100);
  EXPECT_EQ(monitor.Summary().gaps, 2);
  EXPECT_NEAR(monitor.Summary().longest_interval, 0.51, 1e-9);
  EXPECT_TRUE(Finds(monitor.Summary(), "2 gaps, the longest of 0.51 s"));
}

TEST(StreamMonitor, CallsNothingUnder20MillisecondsAGap) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.001, 100);
  Play(&monitor, 0.118, 0.001, 100);
  EXPECT_EQ(monitor.Summary().gaps, 0);
}

TEST(StreamMonitor, FindsASensorThatFreezesForAWhile) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 300);
  for (int index = 0; index < 150; ++index) monitor.AddSample(Time(3.0 + 0.01 * index), AlongZ(7.0));
  Play(&monitor, 4.5, 0.01, 10000);
  EXPECT_EQ(monitor.Summary().repeated, 149);
  EXPECT_NEAR(monitor.Summary().longest_frozen, 1.49, 1e-9);
  EXPECT_EQ(Texts(monitor.Summary()).front(), "frozen sensor: one value for 1.49 s");
}

TEST(StreamMonitor, FindsASensorThatIsFrozenForItsWholeLength) {
  StreamMonitor monitor;
  for (int index = 0; index < 20; ++index) monitor.AddSample(Time(0.01 * index), AlongZ(7.0));
  EXPECT_EQ(Texts(monitor.Summary()).front(), "frozen sensor: one value for its whole length");
  EXPECT_FALSE(Finds(monitor.Summary(), "repeated"));
}

TEST(StreamMonitor, FindsSamplesThatRepeat) {
  StreamMonitor monitor;
  for (int index = 0; index < 1000; ++index) monitor.AddSample(Time(0.01 * index), AlongZ(std::floor(0.5 * index)));
  EXPECT_EQ(monitor.Summary().repeated, 500);
  EXPECT_TRUE(Finds(monitor.Summary(), "repeated samples: 50.1 % equal the sample before"));
  EXPECT_FALSE(Finds(monitor.Summary(), "frozen"));
}

TEST(StreamMonitor, FindsASensorWhoseLastMessageIsSentAgainAndAgain) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 1);
  for (int index = 1; index <= 20; ++index) monitor.AddRepeatedMessage(Time(0.01 * index));
  EXPECT_EQ(monitor.Summary().samples, 1);
  EXPECT_NEAR(monitor.Summary().longest_frozen, 0.2, 1e-9);
  EXPECT_EQ(Texts(monitor.Summary()).front(), "frozen sensor: one value for its whole length");
}

TEST(StreamMonitor, GapsCountIntoNeitherRateNorJitter) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 200);
  Play(&monitor, 100.0, 0.01, 200);
  EXPECT_NEAR(monitor.Summary().rate, 100.0, 1e-6);
  EXPECT_NEAR(monitor.Summary().jitter, 0.0, 1e-9);
}

TEST(StreamMonitor, HasARemedyForEveryFault) {
  StreamSummary summary;
  summary.samples = 100;
  summary.not_finite = summary.out_of_order = summary.zero_stamps = summary.wrong_stamps = summary.jumps_back = 1;
  summary.repeated = 50;
  summary.gaps = 2;
  summary.stamp_steps = summary.arrival_steps = summary.publisher_turns = 2;
  summary.longest_frozen = summary.clock_offset = summary.clock_drift = 2.0;
  summary.rate = 100.0;
  summary.jitter = 1.0;
  const std::vector<Finding> findings = FindingsOf(summary);
  EXPECT_EQ(findings.size(), 14U);
  for (const Finding& finding : findings) EXPECT_FALSE(finding.remedy.empty()) << finding.text;
}

TEST(StreamMonitor, CountsBeyond25DaysAt1Kilohertz) {
  StreamSummary summary;
  summary.samples = 4'000'000'000;
  summary.repeated = 2'000'000'000;
  summary.repeated_messages = 1'000'000'000;
  EXPECT_TRUE(Finds(summary, "repeated samples: 60 % equal the sample before"));
  summary.out_of_order = 3'000'000'000;
  EXPECT_TRUE(Finds(summary, "3000000000 samples not after the one before"));
}

TEST(StreamMonitor, CountsWhatWasDropped) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 20);
  monitor.AddNotFinite();
  monitor.AddNotFinite();
  monitor.AddOutOfOrder();
  EXPECT_EQ(monitor.Summary().samples, 20);
  EXPECT_EQ(monitor.Summary().not_finite, 2);
  EXPECT_EQ(monitor.Summary().out_of_order, 1);
  EXPECT_TRUE(Finds(monitor.Summary(), "2 samples NaN, infinite or above 1e6 N"));
  EXPECT_TRUE(Finds(monitor.Summary(), "1 samples not after the one before"));
}

TEST(StreamMonitor, StartsIntervalsAfreshWhereTimeBeganAnew) {
  StreamMonitor monitor;
  Play(&monitor, 100.0, 0.01, 101);
  monitor.Restart();
  Play(&monitor, 0.0, 0.01, 101);
  const StreamSummary summary = monitor.Summary();
  EXPECT_NEAR(summary.rate, 100.0, 1e-6);
  EXPECT_NEAR(summary.duration, 2.0, 1e-9);
  EXPECT_EQ(summary.gaps, 0);
}

TEST(StreamMonitor, ALapHasOnlyTheGapsFrozenSpellsAndDropsOfItsOwn) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 100);
  for (int index = 0; index < 200; ++index) monitor.AddSample(Time(5.0 + 0.01 * index), AlongZ(7.0));
  monitor.AddNotFinite();
  EXPECT_NEAR(monitor.TakeLap().longest_frozen, 1.99, 1e-9);

  Play(&monitor, 7.0, 0.01, 100);
  const StreamSummary sound = monitor.TakeLap();
  EXPECT_EQ(sound.samples, 100);
  EXPECT_NEAR(sound.rate, 100.0, 1e-6);
  EXPECT_TRUE(Texts(sound).empty());

  Play(&monitor, 8.29, 0.01, 100);
  EXPECT_EQ(Texts(monitor.TakeLap()), std::vector<std::string>{"1 gaps, the longest of 0.3 s"});
}

TEST(StreamMonitor, ALapCountsTheSpellThatBeganBeforeIt) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 100);
  for (int index = 0; index < 100; ++index) monitor.AddSample(Time(1.0 + 0.01 * index), AlongZ(7.0));
  EXPECT_NEAR(monitor.TakeLap().longest_frozen, 0.99, 1e-9);
  for (int index = 100; index < 200; ++index) monitor.AddSample(Time(1.0 + 0.01 * index), AlongZ(7.0));
  EXPECT_NEAR(monitor.TakeLap().longest_frozen, 1.99, 1e-9);
}

TEST(StreamMonitor, LapsJoinToWhatIsCountedWithoutThem) {
  Random random(3);
  StreamMonitor whole;
  StreamMonitor split;
  StreamSummary joined;
  double time = 0.0;
  for (int index = 0; index < 1000; ++index) {
    const Eigen::Vector3d force(random.Uniform(-1.0, 1.0), random.Uniform(3.0, 4.0), index / 100 == 4 ? 0.5 : index);
    time += index == 650 ? 2.0 : random.Uniform(0.004, 0.006);
    for (StreamMonitor* monitor : {&whole, &split}) {
      monitor->AddSample(Time(time), force);
      StreamSummary totals;
      totals.zero_stamps = index / 2;
      totals.wrong_stamps = index / 3;
      totals.episode_faults[0] = index / 4;
      totals.clock_offset = 0.7;
      monitor->SetTotals(totals);
    }
    if (index % 150 == 0) joined = Joined(joined, split.TakeLap());
  }
  joined = Joined(joined, split.TakeLap());
  const StreamSummary expected = whole.Summary();
  for (const StreamSummary& summary : {joined, split.Summary()}) {
    EXPECT_EQ(Texts(summary), Texts(expected));
    EXPECT_EQ(summary.samples, 1000);
    EXPECT_EQ(summary.gaps, 1);
    EXPECT_EQ(summary.intervals, expected.intervals);
    EXPECT_EQ(summary.zero_stamps, 499);
    EXPECT_EQ(summary.episode_faults[0], 249);
    EXPECT_NEAR(summary.rate, expected.rate, 1e-9 * expected.rate);
    EXPECT_NEAR(summary.jitter, expected.jitter, 1e-9 * expected.jitter);
    EXPECT_NEAR(summary.duration, expected.duration, 1e-9);
    EXPECT_EQ(summary.least_force, expected.least_force);
    EXPECT_EQ(summary.greatest_components, expected.greatest_components);
    EXPECT_EQ(summary.least_components, expected.least_components);
  }
}

TEST(StreamMonitor, ReportsWhatTheClockKnowsOfStamps) {
  StreamMonitor monitor;
  Play(&monitor, 0.0, 0.01, 20);
  StreamSummary totals;
  totals.zero_stamps = 3;
  totals.wrong_stamps = 4;
  totals.jumps_back = 1;
  totals.stamp_steps = 2;
  totals.arrival_steps = 5;
  totals.clock_offset = -7200.0;
  totals.clock_drift = 3e-4;
  totals.publisher_turns = 6;
  monitor.SetTotals(totals);
  EXPECT_TRUE(Finds(monitor.Summary(), "3 samples without a stamp"));
  EXPECT_TRUE(Finds(monitor.Summary(), "4 stamps ran backward"));
  EXPECT_TRUE(Finds(monitor.Summary(), "time jumped back once"));
  EXPECT_TRUE(Finds(monitor.Summary(), "the driver's clock was set 2 times"));
  EXPECT_TRUE(Finds(monitor.Summary(), "this machine's clock was set, or the transport became slower, 5 times"));
  EXPECT_TRUE(Finds(monitor.Summary(), "stamps are 7200 s ahead of the time of arrival"));
  EXPECT_TRUE(Finds(monitor.Summary(), "the driver's clock is 300 ppm slow"));
  EXPECT_EQ(Texts(monitor.Summary()).front(), "two publishers on one topic: they took turns 6 times");
  totals = StreamSummary();
  totals.clock_offset = 90061.0;
  monitor.SetTotals(totals);
  EXPECT_TRUE(Finds(monitor.Summary(), "stamps are 90061 s behind the time of arrival"));
  totals.clock_offset = 0.3;
  totals.clock_drift = 1e-4;
  totals.publisher_turns = 1;
  monitor.SetTotals(totals);
  EXPECT_TRUE(Texts(monitor.Summary()).empty());
}

TEST(StreamMonitor, NamesEveryFaultOfEpisodesAndWhatToDo) {
  StreamSummary summary;
  EXPECT_TRUE(EpisodeFindingsOf(summary).empty());
  for (std::size_t fault = 0; fault < kEpisodeFaults; ++fault) summary.episode_faults[fault] = 1;
  summary.waiting_edges = summary.distrusted_edges = summary.repeated_openings = 1;
  const std::vector<Finding> findings = EpisodeFindingsOf(summary);
  EXPECT_EQ(findings.size(), kEpisodeFaults + 3);
  for (const Finding& finding : findings) EXPECT_FALSE(finding.remedy.empty()) << finding.text;
  EXPECT_EQ(DroppedEpisodes(summary), 2);
}

}  // namespace
}  // namespace contact_shapelets::core
