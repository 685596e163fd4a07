#pragma once

#include <actionlib_msgs/GoalStatusArray.h>

/// \file
/// Edges of episodes from the status of an action server.

namespace contact_shapelets {

/// Returns true if the server works on a goal: the goal is active, or active and being cancelled.
bool AnyGoalActive(const actionlib_msgs::GoalStatusArray& status);

}  // namespace contact_shapelets
