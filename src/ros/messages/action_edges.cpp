#include "ros/messages/action_edges.h"

#include <algorithm>

#include "ros/messages/conversions.h"

namespace contact_shapelets {

bool AnyGoalActive(const actionlib_msgs::GoalStatusArray& status) {
  return std::any_of(status.status_list.begin(), status.status_list.end(), [](const actionlib_msgs::GoalStatus& goal) {
    return goal.status == actionlib_msgs::GoalStatus::ACTIVE || goal.status == actionlib_msgs::GoalStatus::PREEMPTING;
  });
}

core::Nanoseconds TimeOfStatus(const actionlib_msgs::GoalStatusArray& status, core::Nanoseconds arrival) {
  return status.header.stamp.isZero() ? arrival : ToNanoseconds(status.header.stamp);
}

}  // namespace contact_shapelets
