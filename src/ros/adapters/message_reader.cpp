#include "ros/adapters/message_reader.h"

namespace contact_shapelets {

void MessageReader::SetType(const std::string& datatype, const std::string& digest, const std::string& definition) {
  if (definition_ && digest_ == digest && datatype_ == datatype) return;
  definition_ = std::make_unique<MessageDefinition>(datatype, definition);
  datatype_ = datatype;
  digest_ = digest;
  header_path_ = definition_->PathOf("std_msgs/Header");
}

std::vector<double> MessageReader::Numbers(const std::string& path) const {
  return definition_->Numbers(path, bytes_.data(), bytes_.size());
}

std::vector<std::string> MessageReader::TextsIfAny(const std::string& field) const {
  if (!definition_->HasTexts(field)) return {};
  return definition_->Texts(field, bytes_.data(), bytes_.size());
}

std_msgs::Header MessageReader::Header() const {
  std_msgs::Header header;
  if (header_path_.empty()) return header;
  const std::vector<double> stamp = Numbers(header_path_ + ".stamp");
  header.stamp = ros::Time(static_cast<std::uint32_t>(stamp[0]), static_cast<std::uint32_t>(stamp[1]));
  header.frame_id = definition_->Text(header_path_ + ".frame_id", bytes_.data(), bytes_.size());
  return header;
}

}  // namespace contact_shapelets
