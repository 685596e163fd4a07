#pragma once

#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ros/messages/message_definition.h"

namespace contact_shapelets {

/// Reads fields of the messages of one topic, live or from a bag, whatever their type.
class MessageReader {
 public:
  /// Takes the message to read: a topic_tools::ShapeShifter or a rosbag::MessageInstance.
  /// \throws std::runtime_error if its definition lacks a type.
  template <typename Message>
  void Take(const Message& message) {
    SetType(message.getDataType(), message.getMD5Sum(), message.getMessageDefinition());
    bytes_.resize(message.size());
    ros::serialization::OStream stream(bytes_.data(), message.size());
    message.write(stream);
  }

  /// Returns the numbers at a path of the message. \throws std::runtime_error as MessageDefinition::Numbers() does.
  std::vector<double> Numbers(const std::string& path) const;
  /// Returns the list of strings in a field of the message; an empty list if it has no such field.
  /// \throws std::runtime_error if the message ends early.
  std::vector<std::string> TextsIfAny(const std::string& field) const;
  /// Returns the header of the message; an empty header if it has none. \throws std::runtime_error if the message ends
  /// early.
  std_msgs::Header Header() const;
  /// Returns the path of the first field of `type`; an empty string if there is none.
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
