/// The wrench adapter reads messages without the driver's package: the connection carries their types.

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>
#include <topic_tools/shape_shifter.h>

#include "ros/adapters/driver_messages.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// A driver that publishes messages of its own type.
class Driver {
 public:
  Driver(const std::string& topic, const topic_tools::ShapeShifter& message)
      : publisher_(message.advertise(node_handle_, topic, 10)) {}

  bool WaitForSubscriber() {
    return WaitUntil([this] { return publisher_.getNumSubscribers() > 0; });
  }
  void Publish(const topic_tools::ShapeShifter& message) { publisher_.publish(message); }

 private:
  ros::NodeHandle node_handle_;
  ros::Publisher publisher_;
};

/// An arm that publishes joint states, and external torques in a message of its driver.
class Arm {
 public:
  explicit Arm(const std::string& name)
      : wrenches(name + "/wrench"),
        joints_(name + "/joint_states", JointStates(ros::Time(), {}, {})),
        driver_(name + "/driver_message", ExternalTorques(ros::Time(), {})) {}

  bool WaitForAdapter() {
    return wrenches.WaitForPublisher() && driver_.WaitForSubscriber() && joints_.WaitForSubscriber();
  }
  void SendPositions(const ros::Time& stamp, const std::vector<double>& positions) {
    joints_.Publish(JointStates(stamp, {}, positions));
  }
  void SendTorques(const ros::Time& stamp) { driver_.Publish(ExternalTorques(stamp, torques_)); }
  /// Sends both with these stamps until their wrench arrives, because topics have separate connections.
  bool SendUntilWrench(const ros::Time& joint_stamp, const ros::Time& torque_stamp) {
    return WaitUntil([&] {
      joints_.Publish(JointStates(joint_stamp, IiwaJoints(), positions_));
      SendTorques(torque_stamp);
      return HasWrench(torque_stamp);
    });
  }
  bool HasWrench(const ros::Time& stamp) const {
    return std::any_of(wrenches.messages().begin(), wrenches.messages().end(),
                       [&stamp](const geometry_msgs::WrenchStamped& wrench) { return wrench.header.stamp == stamp; });
  }

  Inbox<geometry_msgs::WrenchStamped> wrenches;

 private:
  /// Upper arm level, forearm straight down; 5 N upwards at the flange, which lies 0.4 m before the shoulder.
  const std::vector<double> positions_{0.0, M_PI / 2.0, 0.0, -M_PI / 2.0, 0.0, 0.0, 0.0};
  const std::vector<double> torques_{0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  Driver joints_;
  Driver driver_;
};

TEST(WrenchAdapter, ReadsTheWrenchOutOfADriversOwnMessage) {
  Inbox<geometry_msgs::WrenchStamped> wrenches("adapter/wrench");
  topic_tools::ShapeShifter message = DriverMessage(
      "iiwa_msgs/CartesianWrench",
      std::string("Header header\ngeometry_msgs/Wrench wrench\ngeometry_msgs/Wrench inaccuracy\n") + kRule +
          kHeaderDefinition + kRule + "MSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n" + kRule +
          "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
  Driver driver("adapter/driver_message", message);
  ASSERT_TRUE(wrenches.WaitForPublisher() && driver.WaitForSubscriber());
  geometry_msgs::Wrench wrench;
  wrench.force.x = 1.5;
  wrench.torque.y = -0.25;
  Bytes().Add(HeaderOf(ros::Time(1000, 5), "iiwa_link_ee")).Add(wrench).Add(geometry_msgs::Wrench()).Into(&message);
  driver.Publish(message);
  ASSERT_TRUE(wrenches.WaitForCount(1));
  const geometry_msgs::WrenchStamped& received = wrenches.messages().front();
  EXPECT_EQ(received.header.stamp, ros::Time(1000, 5));
  EXPECT_EQ(received.header.frame_id, "iiwa_link_ee");
  EXPECT_EQ(received.wrench, wrench);
}

TEST(WrenchAdapter, PassesAStampedWrenchOn) {
  ros::NodeHandle node_handle;
  Inbox<geometry_msgs::WrenchStamped> wrenches("passing/wrench");
  ros::Publisher driver = node_handle.advertise<geometry_msgs::WrenchStamped>("passing/driver_message", 10);
  ASSERT_TRUE(wrenches.WaitForPublisher() && WaitUntil([&] { return driver.getNumSubscribers() > 0; }));
  driver.publish(WrenchOf(ros::Time(7, 8), 9.0));
  ASSERT_TRUE(wrenches.WaitForCount(1));
  EXPECT_EQ(wrenches.messages().front().wrench, WrenchOf(ros::Time(), 9.0).wrench);
}

TEST(WrenchAdapter, SaysForHowLongTheDriverIsSilent) {
  ros::NodeHandle node_handle;
  Diagnostics diagnostics;
  ros::Publisher driver = node_handle.advertise<geometry_msgs::WrenchStamped>("passing/driver_message", 10);
  ASSERT_TRUE(WaitUntil([&] { return driver.getNumSubscribers() > 0; }));
  ASSERT_TRUE(WaitUntil([&] {
    driver.publish(WrenchOf(ros::Time(9, 0), 9.0));
    return diagnostics.Says("passing/wrench_adapter_node", DiagnosticStatus::OK, "wrench is published");
  }));
  EXPECT_TRUE(diagnostics.WaitFor("passing/wrench_adapter_node", DiagnosticStatus::ERROR, "no message for"));
}

TEST(WrenchAdapter, SaysThatAMessageHoldsNoWrench) {
  ros::NodeHandle node_handle;
  Diagnostics diagnostics;
  ros::Publisher driver = node_handle.advertise<std_msgs::String>("string/driver_message", 10);
  ASSERT_TRUE(WaitUntil([&] { return driver.getNumSubscribers() > 0; }));
  driver.publish(std_msgs::String());
  EXPECT_TRUE(diagnostics.WaitFor("string/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "std_msgs/String holds no geometry_msgs/Wrench"));
}

TEST(WrenchAdapter, MakesJointTorquesAWrenchAtTheFlange) {
  Arm arm("torques");
  ASSERT_TRUE(arm.WaitForAdapter());
  ASSERT_TRUE(arm.SendUntilWrench(ros::Time(1, 0), ros::Time(1, 0)));
  const geometry_msgs::WrenchStamped& received = arm.wrenches.messages().front();
  // The damping near singular poses costs a few hundredths here.
  EXPECT_NEAR(received.wrench.force.z, -5.0, 0.25);
  EXPECT_NEAR(received.wrench.force.x, 0.0, 0.25);
  EXPECT_EQ(received.header.frame_id, "iiwa_link_ee");
}

TEST(WrenchAdapter, TakesNoTorquesFarFromTheStampOfTheJointStates) {
  Diagnostics diagnostics;
  Arm arm("torques");
  ASSERT_TRUE(arm.WaitForAdapter());
  ASSERT_TRUE(arm.SendUntilWrench(ros::Time(10, 0), ros::Time(10, 100'000'000)));
  arm.SendTorques(ros::Time(13, 0));
  EXPECT_TRUE(diagnostics.WaitFor("torques/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "the last joint states are 3.0 s older than the torques"));
  arm.SendTorques(ros::Time(8, 0));
  EXPECT_TRUE(diagnostics.WaitFor("torques/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "the last joint states are 2.0 s newer than the torques"));
  EXPECT_FALSE(arm.HasWrench(ros::Time(13, 0)) || arm.HasWrench(ros::Time(8, 0)));
  EXPECT_TRUE(arm.SendUntilWrench(ros::Time(14, 0), ros::Time(14, 0)));
}

TEST(WrenchAdapter, GoesByArrivalWhereJointStatesHaveNoStamp) {
  Diagnostics diagnostics;
  Arm arm("unstamped");
  ASSERT_TRUE(arm.WaitForAdapter());
  ASSERT_TRUE(arm.SendUntilWrench(ros::Time(), ros::Time(20, 0)));
  ros::WallDuration(0.5).sleep();
  arm.SendTorques(ros::Time(21, 0));
  EXPECT_TRUE(diagnostics.WaitFor("unstamped/wrench_adapter_node", DiagnosticStatus::ERROR, "older than the torques"));
  EXPECT_FALSE(arm.HasWrench(ros::Time(21, 0)));
}

TEST(WrenchAdapter, SaysThatJointStatesCannotBeRead) {
  Diagnostics diagnostics;
  Arm arm("unstamped");
  ASSERT_TRUE(arm.WaitForAdapter());
  arm.SendPositions(ros::Time(), {0.0, 0.0});
  EXPECT_TRUE(diagnostics.WaitFor("unstamped/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "/unstamped/joint_states: position has 2 values, expected 7"));
}

TEST(WrenchAdapter, SaysThatTheRobotsDescriptionIsMissingAndWaitsForIt) {
  Diagnostics diagnostics;
  Arm arm("late");
  ASSERT_TRUE(diagnostics.WaitFor("late/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "the parameter robot_description is not set"));
  ros::param::set("late/robot_description", std::string("<robot name=\"empty\"><link name=\"base\"/></robot>"));
  ASSERT_TRUE(diagnostics.WaitFor("late/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "the robot's description has no link \"iiwa_link_0\""));
  ros::param::set("late/robot_description", ros::param::param("torques/robot_description", std::string()));
  ASSERT_TRUE(arm.WaitForAdapter());
  EXPECT_TRUE(arm.SendUntilWrench(ros::Time(1, 0), ros::Time(1, 0)));
}

TEST(WrenchAdapter, StaysUpAndNamesEachParameterOutOfRange) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("faulty/wrench_adapter_node", [](const DiagnosticStatus& status) {
    return status.level == DiagnosticStatus::ERROR && status.message.find("damping") != std::string::npos &&
           status.message.find("tip_link must name a link of the robot, but is empty") != std::string::npos;
  }));
}

}  // namespace
}  // namespace contact_shapelets::test
