#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/message_instance.h>

#include <optional>
#include <string>

#include "contact_shapelets/ros/wrench_source.h"
#include "ros/adapters/wrench_adapter.h"

namespace contact_shapelets {

/// Reads the wrench from the messages of one topic of a bag: WrenchStamped, or any message that a WrenchAdapter
/// converts, as wrench_adapter_node does live.
class WrenchMessages {
 public:
  /// \throws std::runtime_error if `source` needs a URDF and that has no such arm.
  WrenchMessages(const std::string& topic, const WrenchSource& source);

  /// Returns true if messages of `topic` are to be given to Read().
  bool Reads(const std::string& topic) const { return topic == topic_ || topic == joint_states_; }
  /// The topic with the joint states; empty if the wrench needs none.
  const std::string& joint_states() const { return joint_states_; }
  /// Returns the wrench of a message; nothing if it is a joint state, or holds no wrench that can be used.
  std::optional<geometry_msgs::WrenchStamped> Read(const rosbag::MessageInstance& message);
  /// Returns why the last message without a wrench held none; an empty string if each message so far held one.
  const std::string& fault() const { return fault_; }

 private:
  std::string topic_;
  std::string joint_states_;
  bool plain_ = false;  ///< messages of type WrenchStamped need no adapter
  WrenchAdapter adapter_;
  std::string fault_;
};

}  // namespace contact_shapelets
