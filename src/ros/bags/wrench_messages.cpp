#include "ros/bags/wrench_messages.h"

#include <stdexcept>

namespace contact_shapelets {

WrenchMessages::WrenchMessages(const std::string& topic, const WrenchSource& source)
    : topic_(topic),
      joint_states_(source.adapter.from_torques ? source.joint_states : ""),
      plain_(!source.adapter.from_torques && source.adapter.field.empty()),
      adapter_(source.adapter, source.urdf) {}

std::optional<geometry_msgs::WrenchStamped> WrenchMessages::Read(const rosbag::MessageInstance& message) {
  if (plain_ && message.isType<geometry_msgs::WrenchStamped>()) {
    return *message.instantiate<geometry_msgs::WrenchStamped>();
  }
  try {
    if (message.getTopic() == joint_states_) {
      adapter_.TakeJointStates(message, message.getTime());
      return std::nullopt;
    }
    return adapter_.Convert(message, message.getTime());
  } catch (const std::runtime_error& error) {
    fault_ = message.getTopic() + ": " + error.what();
    return std::nullopt;
  }
}

}  // namespace contact_shapelets
