#pragma once

#include <actionlib_msgs/GoalStatusArray.h>

/// \file
/// Episodes from the status of an action server.

namespace contact_shapelets {

/// True while a goal is being worked on: active, or active and being cancelled.
bool AnyGoalActive(const actionlib_msgs::GoalStatusArray& status);

}  // namespace contact_shapelets
