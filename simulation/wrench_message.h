#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <ros/time.h>

#include "simulated_cell.h"

namespace contact_shapelets::simulation {

constexpr char kWrenchFrame[] = "flange";

/// The robot's estimate as its driver publishes it, with the resolution of a controller: 0.002 N and 0.0005 Nm.
geometry_msgs::WrenchStamped WrenchMessage(const CellState& state, const ros::Time& stamp);

}  // namespace contact_shapelets::simulation
