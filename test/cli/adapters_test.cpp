// Tests bags whose wrench is not a WrenchStamped: the offline program reads them as the adapter node does live.
#include <geometry_msgs/Wrench.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <functional>

#include "cli/made_bags.h"
#include "cli/program.h"
#include "contact_shapelets/ros/episode_bag_reader.h"
#include "ros/adapters/driver_messages.h"
#include "ros/adapters/robot_description.h"
#include "ros/adapters/wrench_adapter.h"

namespace contact_shapelets::test {
namespace {

constexpr char kCartesian[] = "/iiwa/state/CartesianWrench";
constexpr char kTorques[] = "/additional_outputs";
constexpr char kUrdf[] = "test/ros/adapters/iiwa7.urdf";

using WriteWrench = std::function<void(const rosbag::MessageInstance&, const geometry_msgs::WrenchStamped&)>;

/// Copies a bag, but gives each wrench to `write_wrench`.
void Copy(const std::string& from, rosbag::Bag* to, const WriteWrench& write_wrench) {
  const rosbag::Bag input(from, rosbag::bagmode::Read);
  rosbag::View view(input);
  for (const rosbag::MessageInstance& message : view) {
    if (const auto wrench = message.instantiate<geometry_msgs::WrenchStamped>()) {
      write_wrench(message, *wrench);
    } else {
      to->write(message.getTopic(), message.getTime(), message);
    }
  }
}

/// Writes the wrenches of a bag as iiwa_msgs/CartesianWrench.
std::string AsCartesianWrench(const std::string& from, const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  topic_tools::ShapeShifter message = DriverMessage(
      "iiwa_msgs/CartesianWrench",
      std::string("Header header\ngeometry_msgs/Wrench wrench\ngeometry_msgs/Wrench inaccuracy\n") + kRule +
          kHeaderDefinition + kRule + "MSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n" + kRule +
          "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
  Copy(from, &bag, [&](const rosbag::MessageInstance& source, const geometry_msgs::WrenchStamped& wrench) {
    Bytes().Add(wrench.header).Add(wrench.wrench).Add(geometry_msgs::Wrench()).Into(&message);
    bag.write(kCartesian, source.getTime(), message);
  });
  return path;
}

/// Writes for each wrench of a bag the joints' positions and torques that grow with its force.
std::string AsTorques(const std::string& from, const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  const std::vector<double> positions{0.1, 0.5, -0.2, -1.3, 0.3, 0.9, 0.0};
  Copy(from, &bag, [&](const rosbag::MessageInstance& source, const geometry_msgs::WrenchStamped& wrench) {
    std::vector<double> torques;
    for (int joint = 0; joint < 7; ++joint) torques.push_back(0.3 * (4 - joint) * wrench.wrench.force.x);
    // They come first, so that each wrench has its positions.
    bag.write("/joint_states", source.getTime() - ros::Duration(0.001),
              JointStates(wrench.header.stamp, IiwaJoints(), positions));
    bag.write(kTorques, source.getTime(), ExternalTorques(wrench.header.stamp, torques));
  });
  return path;
}

/// Converts the torques of a bag by the adapter of the live node.
std::string Converted(const std::string& from, const WrenchAdapterOptions& options, const std::string& path) {
  WrenchAdapter adapter(options, RobotDescription("iiwa7.urdf"));
  const rosbag::Bag input(from, rosbag::bagmode::Read);
  rosbag::Bag output(path, rosbag::bagmode::Write);
  rosbag::View view(input);
  for (const rosbag::MessageInstance& message : view) {
    if (message.getTopic() == "/joint_states") {
      adapter.TakeJointStates(message, message.getTime());
    } else if (message.getTopic() == kTorques) {
      output.write("/wrench", message.getTime(), adapter.Convert(message, message.getTime()));
    } else {
      output.write(message.getTopic(), message.getTime(), message);
    }
  }
  return path;
}

void ExpectSameEpisodes(const std::vector<core::Episode>& found, const std::vector<core::Episode>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t index = 0; index < found.size(); ++index) {
    EXPECT_EQ(found[index].start, expected[index].start);
    EXPECT_EQ(found[index].force, expected[index].force);
    EXPECT_EQ(found[index].outcome, expected[index].outcome);
  }
}

class AdaptersTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string plain_ = Make(folder_ / "plain.bag", MadeBag());
};

TEST_F(AdaptersTest, AWrenchInAnotherMessageGivesTheSameEpisodes) {
  BagReaderOptions options;
  options.wrench_topic = kCartesian;
  ExpectSameEpisodes(ReadEpisodes(AsCartesianWrench(plain_, folder_ / "iiwa.bag"), options).episodes,
                     ReadEpisodes(plain_, BagReaderOptions()).episodes);
}

TEST_F(AdaptersTest, TorquesGiveTheEpisodesThatTheLiveAdapterWouldGive) {
  const std::string torques = AsTorques(plain_, folder_ / "torques.bag");
  BagReaderOptions options;
  options.wrench_topic = kTorques;
  options.source.adapter.from_torques = true;
  options.source.adapter.base_link = "iiwa_link_0";
  options.source.adapter.tip_link = "iiwa_link_ee";
  options.source.urdf = RobotDescription("iiwa7.urdf");
  const std::vector<core::Episode> episodes = ReadEpisodes(torques, options).episodes;
  EXPECT_GT(episodes.front().force.maxCoeff(), 1.0F);
  const std::string converted = Converted(torques, options.source.adapter, folder_ / "converted.bag");
  ExpectSameEpisodes(episodes, ReadEpisodes(converted, BagReaderOptions()).episodes);
}

TEST_F(AdaptersTest, EveryCommandReadsAWrenchInAnotherMessage) {
  const std::string bag = AsCartesianWrench(plain_, folder_ / "iiwa.bag");
  const std::string model = folder_ / "model.bag";
  const std::string config = WriteFile(folder_ / "q.yaml", "steps: 2\nscales: [0.1, 0.2]\nstart_windows: 300\n");
  const std::vector<std::string> topic{"--wrench-topic", kCartesian};
  const auto run = [&topic](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), topic.begin(), topic.end());
    const ProgramRun result = RunShapelets(arguments);
    EXPECT_EQ(result.status, 0) << arguments.front() << ": " << result.err;
    return result;
  };
  run({"train", bag, "--model", model, "--config", config});
  EXPECT_NE(run({"classify", bag, "--model", model}).out.find("6 episodes by model"), std::string::npos);
  run({"report", model, bag, "--out", folder_ / "report"});
  run({"segment", bag});
  const ProgramRun inspection = run({"inspect", bag});
  EXPECT_NE(inspection.out.find("iiwa_msgs/CartesianWrench, frame flange"), std::string::npos) << inspection.out;
  EXPECT_NE(inspection.out.find("trigger  6 episodes"), std::string::npos) << inspection.out;
}

TEST_F(AdaptersTest, InspectPrintsTheCommandForABagWithoutAWrenchStamped) {
  const std::string iiwa = AsCartesianWrench(plain_, folder_ / "iiwa.bag");
  EXPECT_NE(RunShapelets({"inspect", iiwa})
                .out.find("shapelets train " + iiwa + " --model MODEL.bag --wrench-topic " + kCartesian),
            std::string::npos);
  const std::string torques = AsTorques(plain_, folder_ / "torques.bag");
  const ProgramRun run = RunShapelets({"inspect", torques});
  EXPECT_NE(run.out.find(std::string("--wrench-topic ") + kTorques + " --adapter joint_torques --urdf FILE"),
            std::string::npos)
      << run.out;
}

TEST_F(AdaptersTest, TrainsOnTorquesByTheProgram) {
  const std::string bag = AsTorques(plain_, folder_ / "torques.bag");
  const std::string config = WriteFile(folder_ / "q.yaml", "steps: 2\nscales: [0.1, 0.2]\nstart_windows: 300\n");
  const std::vector<std::string> arguments{
      "train",  bag,         "--model",       folder_ / "model.bag", "--config",    config,       "--wrench-topic",
      kTorques, "--adapter", "joint_torques", "--base-link",         "iiwa_link_0", "--tip-link", "iiwa_link_ee"};
  std::vector<std::string> whole = arguments;
  whole.insert(whole.end(), {"--urdf", kUrdf});
  const ProgramRun run = RunShapelets(whole);
  EXPECT_EQ(run.status, 0) << run.err;
  const ProgramRun without = RunShapelets(arguments);
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.err.find("--adapter joint_torques needs --urdf"), std::string::npos) << without.err;
}

TEST_F(AdaptersTest, ATopicWithoutAWrenchIsRefusedByItsType) {
  const ProgramRun run = RunShapelets({"train", plain_, "--model", folder_ / "m.bag", "--wrench-topic", "/outcome"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("plain.bag: /outcome: std_msgs/String holds no geometry_msgs/Wrench"), std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace contact_shapelets::test
