#pragma once

#include <ros/message_event.h>

#include <optional>
#include <string>

namespace contact_shapelets {

/// Detects when another publisher begins to send, without comparing names for each message.
class PublisherWatch {
 public:
  /// Takes the `header` of a message's connection. Returns the publisher's name if the header is not that of the last
  /// message, else nothing. The name is empty if the header lacks it.
  std::optional<std::string> Next(const boost::shared_ptr<ros::M_string>& header) {
    if (header == last_) return std::nullopt;
    last_ = header;
    return NameOf(header);
  }

  /// Returns the publisher's name in the header of a connection; an empty string if the header lacks it.
  static std::string NameOf(const boost::shared_ptr<ros::M_string>& header) {
    if (!header) return "";
    const auto name = header->find("callerid");
    return name == header->end() ? "" : name->second;
  }

 private:
  boost::shared_ptr<ros::M_string> last_;
};

}  // namespace contact_shapelets
