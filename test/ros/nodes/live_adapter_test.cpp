/// The wrench adapter, on messages of which neither side has the driver's package: their types travel with the
/// connection.

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>
#include <topic_tools/shape_shifter.h>

#include "ros/messages/topics.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr char kRule[] = "================================================================================\n";
constexpr char kHeader[] = "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

/// Serialises values one after the other, as a driver's message would hold them.
class Bytes {
 public:
  template <typename Value>
  Bytes& Add(const Value& value) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + ros::serialization::serializationLength(value));
    ros::serialization::OStream stream(bytes_.data() + before, static_cast<std::uint32_t>(bytes_.size() - before));
    ros::serialization::serialize(stream, value);
    return *this;
  }
  /// Makes them the contents of a message.
  void Into(topic_tools::ShapeShifter* message) {
    ros::serialization::IStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    message->read(stream);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// A driver that publishes one kind of message of its own.
class Driver {
 public:
  Driver(const std::string& topic, const std::string& type, const std::string& definition) {
    message.morph("00112233445566778899aabbccddeeff", type, definition, "");
    publisher_ = message.advertise(node_handle_, topic, 10);
  }
  bool WaitForSubscriber() {
    return WaitUntil([this] { return publisher_.getNumSubscribers() > 0; });
  }
  void Publish() { publisher_.publish(message); }

  topic_tools::ShapeShifter message;

 private:
  ros::NodeHandle node_handle_;
  ros::Publisher publisher_;
};

std_msgs::Header HeaderOf(const ros::Time& stamp, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frame_id;
  return header;
}

/// An arm that publishes joint states and external torques by messages of its driver.
class Arm {
 public:
  explicit Arm(const std::string& name)
      : wrenches(name + "/wrench"),
        joints_(name + "/joint_states", "sensor_msgs/JointState",
                std::string("Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n") +
                    "float64[] effort\n" + kRule + kHeader),
        driver_(name + "/driver_message", "iiwa_driver/AdditionalOutputs",
                std::string("Header header\nstd_msgs/Float64MultiArray external_torques\n") + kRule + kHeader + kRule +
                    "MSG: std_msgs/Float64MultiArray\nMultiArrayLayout layout\nfloat64[] data\n" + kRule +
                    "MSG: std_msgs/MultiArrayLayout\nMultiArrayDimension[] dim\nuint32 data_offset\n" + kRule +
                    "MSG: std_msgs/MultiArrayDimension\nstring label\nuint32 size\nuint32 stride\n") {}

  bool WaitForAdapter() {
    return wrenches.WaitForPublisher() && driver_.WaitForSubscriber() && joints_.WaitForSubscriber();
  }
  void SendPositions(const ros::Time& stamp, const std::vector<double>& positions) {
    Bytes()
        .Add(HeaderOf(stamp, ""))
        .Add(std::vector<std::string>(positions.size(), "iiwa_joint"))
        .Add(positions)
        .Add(std::vector<double>())
        .Add(std::vector<double>())
        .Into(&joints_.message);
    joints_.Publish();
  }
  void SendTorques(const ros::Time& stamp) {
    Bytes().Add(HeaderOf(stamp, "")).Add(std::uint32_t{0}).Add(std::uint32_t{0}).Add(torques_).Into(&driver_.message);
    driver_.Publish();
  }
  /// Sends both with these stamps until their wrench arrives: topics travel apart.
  bool SendUntilWrench(const ros::Time& joint_stamp, const ros::Time& torque_stamp) {
    return WaitUntil([&] {
      SendPositions(joint_stamp, positions_);
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
  Driver driver("adapter/driver_message", "iiwa_msgs/CartesianWrench",
                std::string("Header header\ngeometry_msgs/Wrench wrench\ngeometry_msgs/Wrench inaccuracy\n") + kRule +
                    kHeader + kRule + "MSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n" + kRule +
                    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
  ASSERT_TRUE(wrenches.WaitForPublisher() && driver.WaitForSubscriber());
  geometry_msgs::Wrench wrench;
  wrench.force.x = 1.5;
  wrench.torque.y = -0.25;
  Bytes()
      .Add(HeaderOf(ros::Time(1000, 5), "iiwa_link_ee"))
      .Add(wrench)
      .Add(geometry_msgs::Wrench())
      .Into(&driver.message);
  driver.Publish();
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
                                  "/torques/joint_states is 3.0 s older than the torques"));
  arm.SendTorques(ros::Time(8, 0));
  EXPECT_TRUE(diagnostics.WaitFor("torques/wrench_adapter_node", DiagnosticStatus::ERROR,
                                  "/torques/joint_states is 2.0 s newer than the torques"));
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

TEST(WrenchAdapter, StaysUpAndNamesEachParameterOutOfRange) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("faulty/wrench_adapter_node", [](const DiagnosticStatus& status) {
    return status.level == DiagnosticStatus::ERROR && status.message.find("damping") != std::string::npos &&
           status.message.find("arm_lengths must be in (0, 10] m, but is -0.4") != std::string::npos;
  }));
}

}  // namespace
}  // namespace contact_shapelets::test
