#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// \file
/// Helpers for tests of running nodes. They wait for conditions. Only a failing test reaches their time limits.

namespace contact_shapelets::test {

constexpr double kLimit = 30.0;

/// Handles callbacks until `condition` holds. Returns false if it does not hold within the limit [s].
inline bool WaitUntil(const std::function<bool()>& condition, double limit = kLimit) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(limit);
  while (!condition()) {
    if (ros::WallTime::now() > end) return false;
    ros::spinOnce();
    ros::WallDuration(0.002).sleep();
  }
  return true;
}

/// Keeps the messages of a topic.
template <typename Message>
class Inbox {
 public:
  explicit Inbox(const std::string& topic)
      : subscriber_(node_handle_.subscribe<Message>(
            topic, 1000, [this](const typename Message::ConstPtr& message) { messages_.push_back(*message); })) {}

  bool WaitForPublisher() {
    return WaitUntil([this] { return subscriber_.getNumPublishers() > 0; });
  }
  bool WaitForCount(std::size_t count) {
    return WaitUntil([this, count] { return messages_.size() >= count; });
  }
  void Clear() { messages_.clear(); }
  const std::vector<Message>& messages() const { return messages_; }

 private:
  ros::NodeHandle node_handle_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

/// The last diagnostic status of each node.
class Diagnostics {
 public:
  using Status = diagnostic_msgs::DiagnosticStatus;

  Diagnostics()
      : subscriber_(node_handle_.subscribe<diagnostic_msgs::DiagnosticArray>(
            "/diagnostics", 100, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& array) {
              for (const Status& status : array->status) last_[status.name.substr(0, status.name.find(':'))] = status;
            })) {}

  /// Waits until the status of `node` ("namespace/name") fulfils `condition`.
  bool WaitFor(const std::string& node, const std::function<bool(const Status&)>& condition) {
    return WaitUntil([&] {
      const auto status = last_.find(node);
      return status != last_.end() && condition(status->second);
    });
  }
  /// Returns true if the last status of `node` has this level and its summary holds this text.
  bool Says(const std::string& node, int level, const std::string& part) const {
    const auto status = last_.find(node);
    return status != last_.end() && status->second.level == level &&
           status->second.message.find(part) != std::string::npos;
  }
  /// Waits for a level and a text in the summary.
  bool WaitFor(const std::string& node, int level, const std::string& part) {
    return WaitUntil([&] { return Says(node, level, part); });
  }
  /// Waits for the value of a key.
  bool WaitForValue(const std::string& node, const std::string& key, const std::string& value) {
    return WaitFor(node, [&](const Status& status) {
      return std::any_of(status.values.begin(), status.values.end(),
                         [&](const auto& entry) { return entry.key == key && entry.value == value; });
    });
  }

 private:
  ros::NodeHandle node_handle_;
  std::map<std::string, Status> last_;
  ros::Subscriber subscriber_;
};

/// Returns a wrench with this force along z.
inline geometry_msgs::WrenchStamped WrenchOf(const ros::Time& stamp, double force) {
  geometry_msgs::WrenchStamped wrench;
  wrench.header.stamp = stamp;
  wrench.header.frame_id = "flange";
  wrench.wrench.force.z = force;
  return wrench;
}

/// A force sensor at 200 Hz in real time.
class Sensor {
 public:
  explicit Sensor(const std::string& topic)
      : publisher_(node_handle_.advertise<geometry_msgs::WrenchStamped>(topic, 1000)) {}

  bool WaitForSubscriber() {
    return WaitUntil([this] { return publisher_.getNumSubscribers() > 0; });
  }
  /// Publishes `force` [N], a function of the time after the call, for `duration` [s]. Handles callbacks.
  void Play(double duration, const std::function<double(double)>& force) {
    const ros::Time start = ros::Time::now();
    ros::WallRate rate(200.0);
    double time = 0.0;
    while (time < duration) {
      // Noise of 1 mN, because a constant stream counts as frozen.
      noise_ = 1e-3 - noise_;
      publisher_.publish(WrenchOf(ros::Time::now(), force(time) + noise_));
      ros::spinOnce();
      rate.sleep();
      time = (ros::Time::now() - start).toSec();
    }
  }
  void Publish(const geometry_msgs::WrenchStamped& wrench) { publisher_.publish(wrench); }

 private:
  ros::NodeHandle node_handle_;
  ros::Publisher publisher_;
  double noise_ = 0.0;
};

/// No force, as the argument of Sensor::Play().
inline double FreeAir(double /*time*/) { return 0.0; }

}  // namespace contact_shapelets::test
