#pragma once

#include <ros/ros.h>

#include <functional>

namespace contact_shapelets::benchmark {

/// Waits until `condition` holds; false if it does not within a minute. Callbacks run in another thread.
inline bool WaitUntil(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(60.0);
  while (!condition() && ros::WallTime::now() < end) ros::WallDuration(0.01).sleep();
  return condition();
}

}  // namespace contact_shapelets::benchmark
