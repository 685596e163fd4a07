#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/made_bags.h"
#include "cli/program.h"

namespace contact_shapelets::test {
namespace {

constexpr double kStart = 1000.0;
constexpr double kChange = 20.0;

/// 40 s at 100 Hz: the force swings once a second for `kChange` s, then with sharp pulses four times a second.
std::string MakeChangingBag(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (int sample = 0; sample < 4000; ++sample) {
    const double time = 0.01 * sample;
    const double slow = std::sin(2.0 * M_PI * time);
    const double fast = std::pow(std::sin(8.0 * M_PI * time), 7.0);
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = ros::Time(kStart + time);
    wrench.wrench.force.z = 20.0 + 5.0 * (time < kChange ? slow : fast) + 0.1 * std::sin(1000.0 * time);
    bag.write("/wrench", wrench.header.stamp, wrench);
  }
  return path;
}

/// The ends of the intervals in the table at `path`, but for the last, in seconds from the start.
std::vector<double> Changes(const std::string& path) {
  std::vector<double> changes;
  std::istringstream table(ReadFile(path));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "bag,start,end,score");
  const std::regex row(R"(^[^,]*,([0-9.]+),([0-9.]+),([0-9.]*)$)");
  for (std::smatch match; std::getline(table, line);) {
    EXPECT_TRUE(std::regex_match(line, match, row)) << line;
    if (!match[3].str().empty()) changes.push_back(std::stod(match[2]) - kStart);
  }
  return changes;
}

class SegmentTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(SegmentTest, FindsWhereTheMotionChanges) {
  const std::string table = folder_ / "changes.csv";
  const ProgramRun run = RunShapelets({"segment", MakeChangingBag(folder_ / "changing.bag"), "--csv", table});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("1 change on /wrench"), std::string::npos) << run.out;
  const std::vector<double> changes = Changes(table);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(changes.front(), kChange, 1.0);
}

TEST_F(SegmentTest, FindsItAsAStreamToo) {
  const std::string table = folder_ / "changes.csv";
  const ProgramRun run =
      RunShapelets({"segment", MakeChangingBag(folder_ / "changing.bag"), "--csv", table, "--streaming"});
  EXPECT_EQ(run.status, 0) << run.err;
  const std::vector<double> changes = Changes(table);
  ASSERT_EQ(changes.size(), 1U) << run.out;
  EXPECT_NEAR(changes.front(), kChange, 1.5);
}

TEST_F(SegmentTest, NeedsNoTriggers) {
  MadeBag content;
  content.triggers = false;
  EXPECT_EQ(RunShapelets({"segment", Make(folder_ / "untriggered.bag", content)}).status, 0);
}

TEST_F(SegmentTest, RefusesATableOverItsInput) {
  const std::string bag = MakeChangingBag(folder_ / "changing.bag");
  const std::string before = ReadFile(bag);
  const ProgramRun run = RunShapelets({"segment", bag, "--csv", bag});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(ReadFile(bag), before);
}

TEST_F(SegmentTest, NamesTheTopicsThatABagHasInstead) {
  const ProgramRun run =
      RunShapelets({"segment", MakeChangingBag(folder_ / "changing.bag"), "--wrench-topic", "/other"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("/wrench"), std::string::npos) << run.err;
}

TEST_F(SegmentTest, AWindowThatIsNotPositiveIsWrongUsage) {
  const ProgramRun run = RunShapelets({"segment", MakeChangingBag(folder_ / "changing.bag"), "--window", "-1"});
  EXPECT_EQ(run.status, 2);
}

}  // namespace
}  // namespace contact_shapelets::test
