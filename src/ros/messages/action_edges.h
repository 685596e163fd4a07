#pragma once

#include <actionlib_msgs/GoalStatusArray.h>

#include "contact_shapelets/core/episode.h"

/// \file
/// Episodes from the status of an action server.

namespace contact_shapelets {

/// True while a goal is being worked on: active, or active and being cancelled.
bool AnyGoalActive(const actionlib_msgs::GoalStatusArray& status);

/// When the status was, on the clock of arrivals: its stamp, or `arrival` where it has none.
core::Nanoseconds TimeOfStatus(const actionlib_msgs::GoalStatusArray& status, core::Nanoseconds arrival);

}  // namespace contact_shapelets
