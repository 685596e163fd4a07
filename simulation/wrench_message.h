#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <ros/time.h>

#include "simulated_cell.h"

namespace contact_shapelets::simulation {

constexpr char kWrenchFrame[] = "flange";

/// Returns the robot's estimate as its driver publishes it, rounded to a controller's resolution: 0.002 N and 0.0005
/// Nm.
geometry_msgs::WrenchStamped WrenchMessage(const CellState& state, const ros::Time& stamp);

}  // namespace contact_shapelets::simulation
