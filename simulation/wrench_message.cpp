#include "wrench_message.h"

#include <cmath>

namespace contact_shapelets::simulation {

geometry_msgs::WrenchStamped WrenchMessage(const CellState& state, const ros::Time& stamp) {
  const auto force = [&state](int axis) { return std::round(500.0 * state.wrench[axis]) / 500.0; };
  const auto torque = [&state](int axis) { return std::round(2000.0 * state.wrench[3 + axis]) / 2000.0; };
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = kWrenchFrame;
  message.wrench.force.x = force(0);
  message.wrench.force.y = force(1);
  message.wrench.force.z = force(2);
  message.wrench.torque.x = torque(0);
  message.wrench.torque.y = torque(1);
  message.wrench.torque.z = torque(2);
  return message;
}

}  // namespace contact_shapelets::simulation
