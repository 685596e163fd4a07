#include "ros/messages/message_definition.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <contact_shapelets/ShapeletModel.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace contact_shapelets {
namespace {

template <typename Message>
std::vector<std::uint8_t> Serialised(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <typename Message>
MessageDefinition DefinitionOf() {
  return {ros::message_traits::datatype<Message>(), ros::message_traits::definition<Message>()};
}

TEST(MessageDefinition, FindsAndReadsTheWrenchOfAStampedWrench) {
  const auto definition = DefinitionOf<geometry_msgs::WrenchStamped>();
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "flange";
  message.header.stamp = ros::Time(1700000000, 250);
  message.wrench.force.y = -2.5;
  message.wrench.torque.z = 0.75;
  const auto bytes = Serialised(message);
  ASSERT_EQ(definition.PathOf("geometry_msgs/Wrench"), "wrench");
  EXPECT_EQ(definition.Numbers("wrench", bytes.data(), bytes.size()),
            (std::vector<double>{0.0, -2.5, 0.0, 0.0, 0.0, 0.75}));
  EXPECT_EQ(definition.Numbers("wrench.torque.z", bytes.data(), bytes.size()), std::vector<double>{0.75});
  EXPECT_EQ(definition.Numbers("header.stamp", bytes.data(), bytes.size()), (std::vector<double>{1700000000.0, 250.0}));
  EXPECT_EQ(definition.Text("header.frame_id", bytes.data(), bytes.size()), "flange");
}

TEST(MessageDefinition, NoticesAMessageThatHoldsLessThanItSays) {
  const auto definition = DefinitionOf<ShapeletModel>();
  ShapeletModel message;
  message.shapelets.resize(2);
  message.shapelets[1].values = {1.0F, 2.0F, 3.0F};
  auto bytes = Serialised(message);
  EXPECT_NO_THROW(definition.CheckLengths(bytes.data(), bytes.size()));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(definition.CheckLengths(bytes.data(), size), std::runtime_error) << size;
  }
}

TEST(MessageDefinition, ReadsBeyondConstantsStringsAndNestedArrays) {
  const auto definition = DefinitionOf<ShapeletModel>();
  ShapeletModel message;
  message.model_id = "a model";
  message.sample_period = 0.01;
  message.shapelets.resize(2);
  message.shapelets[0].values = {1.0F, 2.0F, 3.0F};
  message.cluster_labels = {"switched", ""};
  message.selected_scales = {0.25, 0.5};
  message.seed = 42;
  const auto bytes = Serialised(message);
  EXPECT_EQ(definition.Numbers("sample_period", bytes.data(), bytes.size()), std::vector<double>{0.01});
  EXPECT_EQ(definition.Numbers("selected_scales", bytes.data(), bytes.size()), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(definition.Numbers("seed", bytes.data(), bytes.size()), std::vector<double>{42.0});
}

TEST(MessageDefinition, ReadsAnArrayOfFixedLength) {
  const MessageDefinition definition("robot_msgs/State", "float64[3] force # [N]\nuint8 MODE=3\nbool valid\n");
  const std::vector<double> force{1.0, 2.0, 3.0};
  std::vector<std::uint8_t> bytes(25, 1);
  std::copy_n(reinterpret_cast<const std::uint8_t*>(force.data()), 24, bytes.begin());
  EXPECT_EQ(definition.Numbers("force", bytes.data(), bytes.size()), force);
  EXPECT_EQ(definition.Numbers("valid", bytes.data(), bytes.size()), std::vector<double>{1.0});
}

TEST(MessageDefinition, ResolvesTypesOfTheSamePackage) {
  const MessageDefinition definition("robot_msgs/State",
                                     "Header header\nContact contact\n"
                                     "====\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
                                     "====\nMSG: robot_msgs/Contact\nfloat32 force\n");
  EXPECT_EQ(definition.PathOf("robot_msgs/Contact"), "contact");
  EXPECT_EQ(definition.PathOf("std_msgs/Header"), "header");
}

TEST(MessageDefinition, FindsNoPathWithinArraysOrToMissingTypes) {
  EXPECT_EQ(DefinitionOf<actionlib_msgs::GoalStatusArray>().PathOf("actionlib_msgs/GoalID"), "");
  EXPECT_EQ(DefinitionOf<diagnostic_msgs::DiagnosticArray>().PathOf("geometry_msgs/Wrench"), "");
}

TEST(MessageDefinition, RefusesMissingFieldsStringsAndShortMessages) {
  const auto definition = DefinitionOf<geometry_msgs::WrenchStamped>();
  const auto bytes = Serialised(geometry_msgs::WrenchStamped());
  EXPECT_THROW(definition.Numbers("force", bytes.data(), bytes.size()), std::runtime_error);
  EXPECT_THROW(definition.Numbers("header", bytes.data(), bytes.size()), std::runtime_error);
  EXPECT_THROW(definition.Numbers("wrench", bytes.data(), bytes.size() - 1), std::runtime_error);
  EXPECT_THROW(definition.Text("wrench", bytes.data(), bytes.size()), std::runtime_error);
}

TEST(MessageDefinition, NamesATypeThatTheDefinitionLacks) {
  try {
    const MessageDefinition lacking("robot_msgs/State", "Contact contact\n");
    FAIL() << "expected an exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("robot_msgs/Contact"), std::string::npos);
  }
}

}  // namespace
}  // namespace contact_shapelets
