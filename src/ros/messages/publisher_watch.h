#pragma once

#include <ros/message_event.h>

#include <optional>
#include <string>

namespace contact_shapelets {

/// Tells when another publisher begins to send, without a look at names for each message.
class PublisherWatch {
 public:
  /// The publisher's name if `header`, of the message's connection, is not that of the last message; else none. Empty
  /// if the header does not say.
  std::optional<std::string> Next(const boost::shared_ptr<ros::M_string>& header) {
    if (header == last_) return std::nullopt;
    last_ = header;
    return NameOf(header);
  }

  /// The publisher's name in the header of a connection; empty if it does not say.
  static std::string NameOf(const boost::shared_ptr<ros::M_string>& header) {
    if (!header) return "";
    const auto name = header->find("callerid");
    return name == header->end() ? "" : name->second;
  }

 private:
  boost::shared_ptr<ros::M_string> last_;
};

}  // namespace contact_shapelets
