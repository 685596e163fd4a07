#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <ros/time.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/ros/wrench_source.h"
#include "ros/adapters/arm_chain.h"
#include "ros/adapters/message_reader.h"

namespace contact_shapelets {

/// Converts a driver's messages, live or from a bag, to WrenchStamped. It reads them by the definition that comes with
/// them, so it needs no driver's package. Torques need joint positions that are at most 0.2 s older or newer, by the
/// stamps if both have one, else by arrival. An older pose would give a wrong wrench if the arm has moved.
class WrenchAdapter {
 public:
  /// `urdf` is the text of the robot's description. Only torques need it.
  /// \throws std::runtime_error as ArmChain does.
  explicit WrenchAdapter(const WrenchAdapterOptions& options, const std::string& urdf = "");

  /// Takes the joints' positions from a message with a field `position`. If the message names its joints (`name`), the
  /// names say which position is which joint's, else the arm's order does. `arrival` is the time of receipt. `Message`
  /// is a topic_tools::ShapeShifter or a rosbag::MessageInstance. \throws std::runtime_error if a joint of the arm is
  /// missing.
  template <typename Message>
  void TakeJointStates(const Message& message, const ros::Time& arrival) {
    joint_states_.Take(message);
    ReadPositions(arrival);
  }

  /// Returns the wrench of a driver's message, with its stamp. If the message names its joints (`name`), the names say
  /// which torque is which joint's, else the arm's order from base to tip does. `arrival` is the time of receipt.
  /// \throws std::runtime_error if the message holds no wrench or no joint positions fit its torques.
  template <typename Message>
  geometry_msgs::WrenchStamped Convert(const Message& message, const ros::Time& arrival) {
    driver_.Take(message);
    return Convert(arrival);
  }

 private:
  void ReadPositions(const ros::Time& arrival);
  geometry_msgs::WrenchStamped Convert(const ros::Time& arrival) const;
  Wrench ReadWrench() const;
  Wrench WrenchOfTorques(const ros::Time& arrival) const;

  WrenchAdapterOptions options_;
  std::optional<ArmChain> arm_;
  MessageReader driver_;
  MessageReader joint_states_;
  Eigen::VectorXd positions_;  ///< [rad] in the arm's order; empty before the first
  ros::Time positions_stamp_;  ///< zero if they have none
  ros::Time positions_arrival_;
};

}  // namespace contact_shapelets
