#pragma once

namespace contact_shapelets {

/// Waits while another node of this node's name lives, so that it takes over when that one ends. ROS itself would end
/// the other one: two launch files that both start a node, and start it again when it ends, would let neither work. To
/// be called after ros::init() and before the first node handle; a signal ends the process meanwhile. A node that does
/// not answer for two seconds counts as gone.
void WaitForName();

}  // namespace contact_shapelets
