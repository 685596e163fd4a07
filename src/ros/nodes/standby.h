#pragma once

namespace contact_shapelets {

/// Waits as long as another node of the same name lives, then takes over. Without this, ROS would end the other node.
/// If two launch files start and respawn the same node, neither would work. Call this after ros::init() and before the
/// first node handle. A signal ends the process while it waits. A node that does not answer for five seconds hangs. The
/// log says so, and ROS ends it.
void WaitForName();

}  // namespace contact_shapelets
