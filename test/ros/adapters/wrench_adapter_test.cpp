#include "ros/adapters/wrench_adapter.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "ros/adapters/driver_messages.h"
#include "ros/adapters/robot_description.h"

namespace contact_shapelets {
namespace {

using test::ExternalTorques;
using test::IiwaJoints;
using test::JointStates;

/// Upper arm level, forearm straight down; 5 N upwards at the flange, which lies 0.4 m before the shoulder.
const std::vector<double>& Positions() {
  static const std::vector<double> positions{0.0, M_PI / 2.0, 0.0, -M_PI / 2.0, 0.0, 0.0, 0.0};
  return positions;
}
const std::vector<double>& Torques() {
  static const std::vector<double> torques{0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  return torques;
}

WrenchAdapterOptions TorqueOptions() {
  WrenchAdapterOptions options;
  options.from_torques = true;
  options.base_link = "iiwa_link_0";
  options.tip_link = "iiwa_link_ee";
  options.damping = 1e-6;
  return options;
}

WrenchAdapter IiwaAdapter(const WrenchAdapterOptions& options = TorqueOptions()) {
  return WrenchAdapter(options, test::RobotDescription("iiwa7.urdf"));
}

/// Why `action` throws; empty if it does not.
template <typename Action>
std::string FaultOf(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// The flange's z points down.
void ExpectFiveNewtonsUpwards(const geometry_msgs::WrenchStamped& wrench) {
  EXPECT_NEAR(wrench.wrench.force.z, -5.0, 1e-6);
  EXPECT_NEAR(std::hypot(wrench.wrench.force.x, wrench.wrench.force.y), 0.0, 1e-6);
}

TEST(WrenchAdapter, MakesTorquesAWrenchAtTheTip) {
  WrenchAdapter adapter = IiwaAdapter();
  adapter.TakeJointStates(JointStates(ros::Time(1, 0), IiwaJoints(), Positions()), ros::Time(1, 0));
  const auto wrench = adapter.Convert(ExternalTorques(ros::Time(1, 5), Torques()), ros::Time(1, 5));
  ExpectFiveNewtonsUpwards(wrench);
  EXPECT_EQ(wrench.header.stamp, ros::Time(1, 5));
  EXPECT_EQ(wrench.header.frame_id, "iiwa_link_ee");
}

TEST(WrenchAdapter, FindsPositionsByTheNamesOfTheJoints) {
  std::vector<std::string> names = IiwaJoints();
  std::vector<double> positions = Positions();
  std::reverse(names.begin(), names.end());
  std::reverse(positions.begin(), positions.end());
  names.insert(names.begin() + 2, "gripper");
  positions.insert(positions.begin() + 2, 0.7);
  WrenchAdapter adapter = IiwaAdapter();
  adapter.TakeJointStates(JointStates(ros::Time(1, 0), names, positions), ros::Time(1, 0));
  ExpectFiveNewtonsUpwards(adapter.Convert(ExternalTorques(ros::Time(1, 0), Torques()), ros::Time(1, 0)));
}

TEST(WrenchAdapter, TakesPositionsWithoutNamesInTheArmsOrder) {
  WrenchAdapter adapter = IiwaAdapter();
  adapter.TakeJointStates(JointStates(ros::Time(1, 0), {}, Positions()), ros::Time(1, 0));
  ExpectFiveNewtonsUpwards(adapter.Convert(ExternalTorques(ros::Time(1, 0), Torques()), ros::Time(1, 0)));
}

TEST(WrenchAdapter, FindsTorquesByNameIfTheirMessageNamesJoints) {
  WrenchAdapterOptions options = TorqueOptions();
  options.field = "effort";
  std::vector<std::string> names = IiwaJoints();
  std::vector<double> positions = Positions();
  std::vector<double> torques = Torques();
  std::reverse(names.begin(), names.end());
  std::reverse(positions.begin(), positions.end());
  std::reverse(torques.begin(), torques.end());
  const topic_tools::ShapeShifter both = JointStates(ros::Time(1, 0), names, positions, torques);
  WrenchAdapter adapter = IiwaAdapter(options);
  adapter.TakeJointStates(both, ros::Time(1, 0));
  ExpectFiveNewtonsUpwards(adapter.Convert(both, ros::Time(1, 0)));
}

TEST(WrenchAdapter, ReadsTheMessagesOfABag) {
  const std::string path = (std::filesystem::temp_directory_path() / "wrench_adapter_test.bag").string();
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    bag.write("/joint_states", ros::Time(1, 0), JointStates(ros::Time(), IiwaJoints(), Positions()));
    bag.write("/torques", ros::Time(1, 100'000'000), ExternalTorques(ros::Time(), Torques()));
    bag.write("/torques", ros::Time(2, 0), ExternalTorques(ros::Time(), Torques()));
  }
  WrenchAdapter adapter = IiwaAdapter();
  std::vector<geometry_msgs::WrenchStamped> wrenches;
  std::string fault;
  const rosbag::Bag bag(path, rosbag::bagmode::Read);
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) {
    if (message.getTopic() == "/joint_states") {
      adapter.TakeJointStates(message, message.getTime());
    } else {
      fault = FaultOf([&] { wrenches.push_back(adapter.Convert(message, message.getTime())); });
    }
  }
  std::filesystem::remove(path);
  ASSERT_EQ(wrenches.size(), 1U);
  ExpectFiveNewtonsUpwards(wrenches.front());
  EXPECT_EQ(fault, "the last joint states are 1.0 s older than the torques, more than 0.2 s");
}

TEST(WrenchAdapter, SaysWhichJointIsMissing) {
  std::vector<std::string> names = IiwaJoints();
  names[2] = "gripper";
  WrenchAdapter adapter = IiwaAdapter();
  const auto states = JointStates(ros::Time(1, 0), names, Positions());
  EXPECT_EQ(FaultOf([&] { adapter.TakeJointStates(states, ros::Time(1, 0)); }),
            "joint iiwa_joint_3 of the robot's description is not among the names: iiwa_joint_1, iiwa_joint_2, "
            "gripper, iiwa_joint_4, iiwa_joint_5, iiwa_joint_6, iiwa_joint_7");
}

TEST(WrenchAdapter, SaysHowManyValuesItExpects) {
  WrenchAdapter adapter = IiwaAdapter();
  const auto unnamed = JointStates(ros::Time(1, 0), {}, {0.0, 0.0});
  const auto named = JointStates(ros::Time(1, 0), IiwaJoints(), {});
  EXPECT_EQ(FaultOf([&] { adapter.TakeJointStates(unnamed, ros::Time(1, 0)); }), "position has 2 values, expected 7");
  EXPECT_EQ(FaultOf([&] { adapter.TakeJointStates(named, ros::Time(1, 0)); }), "position has 0 values, expected 7");
  adapter.TakeJointStates(JointStates(ros::Time(1, 0), {}, Positions()), ros::Time(1, 0));
  const auto torques = ExternalTorques(ros::Time(1, 0), {1.0, 2.0, 3.0});
  EXPECT_EQ(FaultOf([&] { adapter.Convert(torques, ros::Time(1, 0)); }),
            "external_torques.data has 3 values, expected 7");
}

TEST(WrenchAdapter, PassesOverTheJointsOfOtherDevices) {
  WrenchAdapter adapter = IiwaAdapter();
  const auto gripper = JointStates(ros::Time(1, 0), {"left_finger", "right_finger"}, {0.01, 0.02});
  const auto torques = ExternalTorques(ros::Time(1, 0), Torques());
  adapter.TakeJointStates(gripper, ros::Time(1, 0));
  EXPECT_EQ(FaultOf([&] { adapter.Convert(torques, ros::Time(1, 0)); }),
            "no joint states yet of iiwa_joint_1, iiwa_joint_2, iiwa_joint_3, iiwa_joint_4, iiwa_joint_5, "
            "iiwa_joint_6, iiwa_joint_7");
  adapter.TakeJointStates(JointStates(ros::Time(1, 0), IiwaJoints(), Positions()), ros::Time(1, 0));
  adapter.TakeJointStates(gripper, ros::Time(1, 0));
  ExpectFiveNewtonsUpwards(adapter.Convert(torques, ros::Time(1, 0)));
}

TEST(WrenchAdapterOptions, NameTheLinksThatTorquesNeed) {
  WrenchAdapterOptions options;
  EXPECT_EQ(options.Faults(), "");
  options.from_torques = true;
  options.damping = -1.0;
  const std::string faults = options.Faults();
  for (const char* const part : {"damping", "base_link", "tip_link"}) {
    EXPECT_NE(faults.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace contact_shapelets
