/// The wrench adapter, on messages of which neither side has the driver's package: their types travel with the
/// connection.

#include <contact_shapelets/ros/topics.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>
#include <topic_tools/shape_shifter.h>

#include "live_helpers.h"

namespace contact_shapelets::test {
namespace {

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

TEST(WrenchAdapter, SaysThatAMessageHoldsNoWrench) {
  ros::NodeHandle node_handle;
  Diagnostics diagnostics;
  ros::Publisher driver = node_handle.advertise<std_msgs::String>("string/driver_message", 10);
  ASSERT_TRUE(WaitUntil([&] { return driver.getNumSubscribers() > 0; }));
  driver.publish(std_msgs::String());
  EXPECT_TRUE(diagnostics.WaitFor("string/wrench_adapter_node", diagnostic_msgs::DiagnosticStatus::ERROR,
                                  "std_msgs/String holds no geometry_msgs/Wrench"));
}

TEST(WrenchAdapter, MakesJointTorquesAWrenchAtTheFlange) {
  Inbox<geometry_msgs::WrenchStamped> wrenches("torques/wrench");
  Driver joints(
      "torques/joint_states", "sensor_msgs/JointState",
      std::string("Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n") + kRule +
          kHeader);
  Driver driver("torques/driver_message", "iiwa_driver/AdditionalOutputs",
                std::string("Header header\nstd_msgs/Float64MultiArray external_torques\n") + kRule + kHeader + kRule +
                    "MSG: std_msgs/Float64MultiArray\nMultiArrayLayout layout\nfloat64[] data\n" + kRule +
                    "MSG: std_msgs/MultiArrayLayout\nMultiArrayDimension[] dim\nuint32 data_offset\n" + kRule +
                    "MSG: std_msgs/MultiArrayDimension\nstring label\nuint32 size\nuint32 stride\n");
  ASSERT_TRUE(wrenches.WaitForPublisher() && driver.WaitForSubscriber() && joints.WaitForSubscriber());
  // Upper arm level, forearm straight down; 5 N upwards at the flange, which lies 0.4 m before the shoulder.
  const std::vector<double> positions{0.0, M_PI / 2.0, 0.0, -M_PI / 2.0, 0.0, 0.0, 0.0};
  const std::vector<double> torques{0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  Bytes()
      .Add(HeaderOf(ros::Time(1, 0), ""))
      .Add(std::vector<std::string>(7, "iiwa_joint"))
      .Add(positions)
      .Add(std::vector<double>())
      .Add(std::vector<double>())
      .Into(&joints.message);
  Bytes()
      .Add(HeaderOf(ros::Time(1, 0), ""))
      .Add(std::uint32_t{0})
      .Add(std::uint32_t{0})
      .Add(torques)
      .Into(&driver.message);
  // Topics travel apart: torques that arrive before the first positions give no wrench.
  ASSERT_TRUE(WaitUntil([&] {
    joints.Publish();
    driver.Publish();
    return !wrenches.messages().empty();
  }));
  const geometry_msgs::WrenchStamped& received = wrenches.messages().front();
  // The damping near singular poses costs a few hundredths here.
  EXPECT_NEAR(received.wrench.force.z, -5.0, 0.25);
  EXPECT_NEAR(received.wrench.force.x, 0.0, 0.25);
  EXPECT_EQ(received.header.frame_id, "iiwa_link_ee");
}

TEST(WrenchAdapter, StaysUpAndNamesEachParameterOutOfRange) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("faulty/wrench_adapter_node", [](const diagnostic_msgs::DiagnosticStatus& status) {
    return status.level == diagnostic_msgs::DiagnosticStatus::ERROR &&
           status.message.find("damping") != std::string::npos &&
           status.message.find("arm_lengths must be above 0 m, but one is -0.4") != std::string::npos;
  }));
}

}  // namespace
}  // namespace contact_shapelets::test
