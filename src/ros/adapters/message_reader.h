#pragma once

#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ros/messages/message_definition.h"

namespace contact_shapelets {

/// Takes the messages of one topic apart, whatever their type: off the wire or out of a bag.
class MessageReader {
 public:
  /// Makes `message` the one that is read: a topic_tools::ShapeShifter or a rosbag::MessageInstance.
  /// \throws std::runtime_error if its definition lacks a type.
  template <typename Message>
  void Take(const Message& message) {
    SetType(message.getDataType(), message.getMD5Sum(), message.getMessageDefinition());
    bytes_.resize(message.size());
    ros::serialization::OStream stream(bytes_.data(), message.size());
    message.write(stream);
  }

  /// The numbers at a path of the message. \throws std::runtime_error as MessageDefinition::Numbers() does.
  std::vector<double> Numbers(const std::string& path) const;
  /// The list of strings in a field of the message; empty if it has no such field.
  /// \throws std::runtime_error if the message ends early.
  std::vector<std::string> TextsIfAny(const std::string& field) const;
  /// The header of the message; empty if it has none. \throws std::runtime_error if the message ends early.
  std_msgs::Header Header() const;
  /// The path of the first field of `type`; empty if there is none.
  std::string PathOf(const std::string& type) const { return definition_->PathOf(type); }
  /// The type of the message: "package/Type".
  const std::string& datatype() const { return datatype_; }

 private:
  void SetType(const std::string& datatype, const std::string& digest, const std::string& definition);

  std::string datatype_;
  std::string digest_;  ///< MD5 of the type that `definition_` describes
  std::unique_ptr<MessageDefinition> definition_;
  std::string header_path_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace contact_shapelets
