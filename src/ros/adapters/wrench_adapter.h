#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <ros/time.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "ros/adapters/arm_chain.h"
#include "ros/adapters/message_reader.h"
#include "ros/adapters/wrench_adapter_options.h"

namespace contact_shapelets {

/// Makes a WrenchStamped of the messages of a driver that has none, off the wire or out of a bag. Messages are read by
/// the definition that comes with them, so that no driver's package is needed. Torques become a wrench by joint
/// positions that are at most 0.2 s older or newer, by the stamps if both have one, else by arrival: the last pose of
/// an arm that has gone on moving would give a wrench that nothing exerts.
class WrenchAdapter {
 public:
  /// `urdf`: the text of the robot's description, read only for torques.
  /// \throws std::runtime_error as ArmChain does.
  explicit WrenchAdapter(const WrenchAdapterOptions& options, const std::string& urdf = "");

  /// Takes the joints' positions out of a message with a field `position`. If the message names its joints (`name`),
  /// the positions go to the arm's joints by name, else by the arm's order. `arrival` is the time of receipt. `Message`
  /// is a topic_tools::ShapeShifter or a rosbag::MessageInstance. \throws std::runtime_error if a joint of the arm is
  /// missing.
  template <typename Message>
  void TakeJointStates(const Message& message, const ros::Time& arrival) {
    joint_states_.Take(message);
    ReadPositions(arrival);
  }

  /// The wrench of a driver's message, with its stamp. Torques are in the arm's order from base to tip, or go by name
  /// if the message names its joints. `arrival` is the time of receipt. \throws std::runtime_error if the message holds
  /// no wrench, or no positions fit its torques.
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
  Eigen::VectorXd positions_;  ///< [rad] in the arm's order; empty before there were any
  ros::Time positions_stamp_;  ///< zero if they have none
  ros::Time positions_arrival_;
};

}  // namespace contact_shapelets
