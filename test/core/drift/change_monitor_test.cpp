#include "core/drift/change_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

constexpr int kGroups = 3;

/// A push of one of three kinds, whose forces and durations scatter by 5 %.
WatchedEpisode Push(Random* random, double force = 1.0) {
  WatchedEpisode push;
  push.group = random->Index(kGroups);
  push.event = std::string(1, static_cast<char>('a' + push.group));
  const double common = 0.05 * random->Normal() + std::log(force);
  push.traits = {std::log(8.0 + push.group) + common, std::log(20.0 + push.group) + common,
                 std::log(4.0 + push.group) + common + 0.02 * random->Normal(),
                 std::log(2.0 - 0.2 * push.group) + 0.05 * random->Normal(), std::log(0.5) + 0.2 * random->Normal()};
  return push;
}

std::vector<WatchedEpisode> Pushes(int count, Random* random) {
  std::vector<WatchedEpisode> pushes;
  for (int index = 0; index < count; ++index) pushes.push_back(Push(random));
  return pushes;
}

ChangeMonitor Trained(int count, Random* random) { return {Pushes(count, random), ChangeOptions{}}; }

TEST(ChangeMonitor, AlarmsNoMoreOftenThanStatedWithoutAChange) {
  constexpr int kRuns = 100;
  int alarms = 0;
  for (int run = 0; run < kRuns; ++run) {
    Random random(StreamSeed(11, static_cast<std::uint32_t>(run)));
    ChangeMonitor monitor = Trained(60, &random);
    for (int episode = 0; episode < 500; ++episode) monitor.Append(Push(&random));
    alarms += monitor.change() ? 1 : 0;
  }
  EXPECT_LE(alarms, 5);
}

TEST(ChangeMonitor, TellsAWeakerForceWithinThirtyEpisodes) {
  Random random(5);
  ChangeMonitor monitor = Trained(100, &random);
  for (int episode = 0; episode < 200; ++episode) monitor.Append(Push(&random));
  ASSERT_FALSE(monitor.change());
  for (int episode = 0; episode < 30 && !monitor.change(); ++episode) monitor.Append(Push(&random, 0.8));
  ASSERT_TRUE(monitor.change());
  EXPECT_FALSE(monitor.change()->rate);
  EXPECT_NE(monitor.change()->what.find("force"), std::string::npos);
  EXPECT_NEAR(monitor.change()->since / monitor.change()->before, 0.8, 0.08);
  EXPECT_NEAR(static_cast<double>(monitor.change()->first), 200.0, 5.0);
}

TEST(ChangeMonitor, NamesTheGroupThatAloneChanged) {
  Random random(6);
  ChangeMonitor monitor = Trained(200, &random);
  for (int episode = 0; episode < 500 && !monitor.change(); ++episode) {
    WatchedEpisode push = Push(&random);
    // One of ten only, since the change is not to show in all groups together.
    if (random.Index(10) > 0 && push.group == 1) continue;
    if (push.group == 1) push.traits[3] += 0.3;
    monitor.Append(push);
  }
  ASSERT_TRUE(monitor.change());
  EXPECT_EQ(monitor.change()->what, "duration");
  ASSERT_TRUE(monitor.change()->group);
  EXPECT_EQ(*monitor.change()->group, 1);
  EXPECT_GT(monitor.change()->since, 1.2 * monitor.change()->before);
}

TEST(ChangeMonitor, TellsAnEventThatBecameMoreFrequent) {
  Random random(8);
  ChangeMonitor monitor = Trained(60, &random);
  const auto append = [&](double rate) {
    WatchedEpisode push = Push(&random);
    push.event = random.Uniform() < rate ? "c" : "a";
    monitor.Append(push);
  };
  for (int episode = 0; episode < 1000; ++episode) append(0.01);
  ASSERT_FALSE(monitor.change()) << monitor.change()->what;
  for (int episode = 0; episode < 300 && !monitor.change(); ++episode) append(0.2);
  ASSERT_TRUE(monitor.change());
  EXPECT_TRUE(monitor.change()->rate);
  EXPECT_EQ(monitor.change()->what, "c");
  EXPECT_LT(monitor.change()->before, 0.03);
  EXPECT_GT(monitor.change()->since, 0.05);
}

TEST(ChangeMonitor, TellsTheDirectionThoughTheSharesOfGroupsChangeToo) {
  Random random(15);
  std::vector<WatchedEpisode> training = Pushes(90, &random);
  for (WatchedEpisode& push : training) push.traits[1] += push.group == 2 ? 1.0 : 0.0;
  ChangeMonitor monitor(training, ChangeOptions{});
  for (int episode = 0; episode < 400 && !monitor.change(); ++episode) {
    WatchedEpisode push = Push(&random, 0.8);
    // Only the group of the greatest forces comes now, and they are lower.
    if (push.group != 2) continue;
    push.event = "a";
    push.traits[1] += 1.0;
    monitor.Append(push);
  }
  ASSERT_TRUE(monitor.change());
  EXPECT_LT(monitor.change()->since, monitor.change()->before);
}

TEST(ChangeMonitor, KeepsTheFirstChange) {
  Random random(9);
  ChangeMonitor monitor = Trained(100, &random);
  while (!monitor.change()) monitor.Append(Push(&random, 0.7));
  const std::int64_t first = monitor.change()->first;
  for (int episode = 0; episode < 100; ++episode) monitor.Append(Push(&random, 2.0));
  EXPECT_EQ(monitor.change()->first, first);
}

TEST(ChangeMonitor, TakesGroupsThatTheTrainingLacks) {
  Random random(10);
  ChangeMonitor monitor = Trained(60, &random);
  WatchedEpisode push = Push(&random);
  push.group = 17;
  for (int episode = 0; episode < 50; ++episode) monitor.Append(push);
  EXPECT_EQ(monitor.count(), 50);
}

TEST(ChangeMonitor, TellsNothingOfAGroupWithOneTrainingEpisode) {
  Random random(12);
  ChangeMonitor monitor({Push(&random)}, ChangeOptions{});
  for (int episode = 0; episode < 20; ++episode) monitor.Append(Push(&random));
  EXPECT_FALSE(monitor.change());
}

TEST(ChangeMonitor, WatchesATraitThatTheTrainingLacks) {
  Random random(14);
  std::vector<WatchedEpisode> training = Pushes(60, &random);
  for (WatchedEpisode& push : training) push.traits[4] = std::numeric_limits<double>::quiet_NaN();
  ChangeMonitor monitor(training, ChangeOptions{});
  for (int episode = 0; episode < 300; ++episode) monitor.Append(Push(&random));
  ASSERT_FALSE(monitor.change());
  for (int episode = 0; episode < 100 && !monitor.change(); ++episode) {
    WatchedEpisode push = Push(&random);
    push.traits[4] += 1.0;
    monitor.Append(push);
  }
  ASSERT_TRUE(monitor.change());
  EXPECT_EQ(monitor.change()->what, "novelty");
  EXPECT_NEAR(static_cast<double>(monitor.change()->first), 300.0, 5.0);
}

TEST(ChangeMonitor, RefusesAProbabilityOutOfRange) {
  for (const double probability : {0.0, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(ChangeMonitor({}, ChangeOptions{probability, 1}), std::invalid_argument) << probability;
  }
}

TEST(Traits, AreLogarithmsOfForcesAndDuration) {
  Episode episode;
  episode.sample_period = 0.5;
  episode.force.resize(4);
  episode.force << 1.0F, 3.0F, 1.0F, 3.0F;
  const Traits traits = TraitsOf(episode, 0.5);
  EXPECT_NEAR(traits[0], std::log(2.0), 1e-6);
  EXPECT_NEAR(traits[1], std::log(3.0), 1e-6);
  EXPECT_NEAR(traits[2], std::log(1.0), 1e-6);
  EXPECT_NEAR(traits[3], std::log(2.0), 1e-6);
  EXPECT_NEAR(traits[4], std::log(0.5), 1e-6);
}

TEST(Traits, AreFiniteWithoutForce) {
  Episode episode;
  episode.sample_period = 0.01;
  episode.force = Eigen::VectorXf::Zero(10);
  for (const double trait : TraitsOf(episode, 0.5)) EXPECT_TRUE(std::isfinite(trait));
}

}  // namespace
}  // namespace contact_shapelets::core
