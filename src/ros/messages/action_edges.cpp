#include "ros/messages/action_edges.h"

#include <algorithm>

namespace contact_shapelets {

bool AnyGoalActive(const actionlib_msgs::GoalStatusArray& status) {
  return std::any_of(status.status_list.begin(), status.status_list.end(), [](const actionlib_msgs::GoalStatus& goal) {
    return goal.status == actionlib_msgs::GoalStatus::ACTIVE || goal.status == actionlib_msgs::GoalStatus::PREEMPTING;
  });
}

}  // namespace contact_shapelets
