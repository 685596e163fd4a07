#pragma once

#include <ros/serialization.h>
#include <std_msgs/Header.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Messages of drivers whose packages are not there: their types travel with them.

namespace contact_shapelets::test {

constexpr char kRule[] = "================================================================================\n";
constexpr char kHeaderDefinition[] = "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

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

/// An empty message of a type.
inline topic_tools::ShapeShifter DriverMessage(const std::string& type, const std::string& definition) {
  topic_tools::ShapeShifter message;
  // Readers go by the digest to tell types apart; nobody checks it against the definition.
  message.morph("00112233445566778899aabbccddeeff", type, definition, "");
  return message;
}

inline std_msgs::Header HeaderOf(const ros::Time& stamp, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = frame_id;
  return header;
}

/// A sensor_msgs/JointState with these positions; `names` may be empty.
inline topic_tools::ShapeShifter JointStates(const ros::Time& stamp, const std::vector<std::string>& names,
                                             const std::vector<double>& positions,
                                             const std::vector<double>& efforts = {}) {
  topic_tools::ShapeShifter message = DriverMessage(
      "sensor_msgs/JointState",
      std::string("Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n") + kRule +
          kHeaderDefinition);
  Bytes().Add(HeaderOf(stamp, "")).Add(names).Add(positions).Add(std::vector<double>()).Add(efforts).Into(&message);
  return message;
}

/// An iiwa_driver/AdditionalOutputs with these external torques.
inline topic_tools::ShapeShifter ExternalTorques(const ros::Time& stamp, const std::vector<double>& torques) {
  topic_tools::ShapeShifter message = DriverMessage(
      "iiwa_driver/AdditionalOutputs",
      std::string("Header header\nstd_msgs/Float64MultiArray external_torques\n") + kRule + kHeaderDefinition + kRule +
          "MSG: std_msgs/Float64MultiArray\nMultiArrayLayout layout\nfloat64[] data\n" + kRule +
          "MSG: std_msgs/MultiArrayLayout\nMultiArrayDimension[] dim\nuint32 data_offset\n" + kRule +
          "MSG: std_msgs/MultiArrayDimension\nstring label\nuint32 size\nuint32 stride\n");
  Bytes().Add(HeaderOf(stamp, "")).Add(std::uint32_t{0}).Add(std::uint32_t{0}).Add(torques).Into(&message);
  return message;
}

/// Names of the joints in iiwa7.urdf and iiwa14.urdf, from base to tip.
inline std::vector<std::string> IiwaJoints() {
  std::vector<std::string> names;
  for (int joint = 1; joint <= 7; ++joint) names.push_back("iiwa_joint_" + std::to_string(joint));
  return names;
}

}  // namespace contact_shapelets::test
