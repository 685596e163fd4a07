#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/made_bags.h"
#include "cli/program.h"
#include "contact_shapelets/Episode.h"
#include "contact_shapelets/core/episode.h"
#include "core/numerics/random.h"
#include "ros/messages/conversions.h"

namespace contact_shapelets::test {
namespace {

constexpr double kFirst = 1000.0;
constexpr double kApart = 10.0;

/// A bag of `count` pushes, number `begin` and later ones, whose force scatters by 3 % around `force` [N].
std::string MakePushes(const std::string& path, int begin, int count, double force) {
  core::Random random(static_cast<std::uint64_t>(begin) + 1);
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (int push = begin; push < begin + count; ++push) {
    core::Episode episode;
    episode.id = "push_" + std::to_string(push);
    episode.sample_period = 0.01;
    episode.start = core::FromSeconds(kFirst + kApart * push);
    episode.end_reason = core::EndReason::kTrigger;
    episode.force.resize(120);
    const double greatest = force * (1.0 + 0.03 * random.Normal());
    for (Eigen::Index sample = 0; sample < episode.force.size(); ++sample) {
      const double pulse = std::sin(M_PI * static_cast<double>(sample) / 120.0);
      episode.force[sample] = static_cast<float>(std::abs(greatest * pulse * pulse + 0.05 * random.Normal()));
    }
    bag.write("/episode", ros::Time(core::ToSeconds(episode.start) + 1.2), ToMessage(episode));
  }
  return path;
}

class DriftTest : public testing::Test {
 protected:
  DriftTest() {
    WriteFile(quick_, "steps: 2\nscales: [0.3]\nclusters: 2\n");
    EXPECT_EQ(RunShapelets({"train", first_, "--model", model_, "--config", quick_}).status, 0);
  }

  TemporaryFolder folder_;
  std::string quick_ = folder_ / "quick.yaml";
  std::string model_ = folder_ / "model.bag";
  std::string first_ = MakePushes(folder_ / "first.bag", 0, 60, 20.0);
  std::string weaker_ = MakePushes(folder_ / "weaker.bag", 60, 30, 16.0);
};

TEST_F(DriftTest, TellsSinceWhenWhatChangedAndWhichWay) {
  // The order of the arguments is not that of time.
  const ProgramRun run = RunShapelets({"drift", model_, weaker_, first_});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("90 episodes: since some episode near push_"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("force"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("is lower by 2"), std::string::npos) << run.out;
}

TEST_F(DriftTest, TellsNothingWithoutAChange) {
  const ProgramRun run = RunShapelets({"drift", model_, first_, "--reference", "30"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("60 episodes: no change"), std::string::npos) << run.out;
}

TEST_F(DriftTest, SaysThatEpisodesAreTooFew) {
  const ProgramRun run = RunShapelets({"drift", model_, weaker_});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("30 episodes: too few"), std::string::npos) << run.out;
}

TEST_F(DriftTest, WritesTheEvidenceOfEachEpisode) {
  const std::string table = folder_ / "drift.csv";
  ASSERT_EQ(RunShapelets({"drift", model_, first_, weaker_, "--csv", table}).status, 0);
  const std::vector<std::string> lines = Lines(ReadFile(table));
  ASSERT_EQ(lines.size(), 91U);
  EXPECT_EQ(lines[0], "episode_id,start,event,log_evidence,change");
  EXPECT_EQ(lines[1].substr(0, 16), "push_0,1000.000,");
  EXPECT_EQ(lines[1].back(), '0');
  EXPECT_EQ(lines[90].back(), '1');
}

TEST_F(DriftTest, RefusesOptionsOutOfRange) {
  EXPECT_EQ(RunShapelets({"drift", model_, first_, "--reference", "2"}).status, 2);
  EXPECT_EQ(RunShapelets({"drift", model_, first_, "--false-alarm-probability", "1"}).status, 2);
  EXPECT_EQ(RunShapelets({"drift", model_, first_, "--csv", model_}).status, 1);
}

}  // namespace
}  // namespace contact_shapelets::test
