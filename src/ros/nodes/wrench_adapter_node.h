#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <memory>
#include <string>

#include "ros/adapters/wrench_adapter.h"

namespace contact_shapelets {

/// Publishes `wrench` for drivers that have it in a message of their own, or only the external torques of the joints:
/// WrenchAdapter between topics. For torques it needs the parameter `robot_description`, which it looks for in its own
/// namespace and those above until it is set. Its callbacks need a queue that one thread serves.
class WrenchAdapterNode {
 public:
  /// Reads parameters from `private_node_handle` and subscribes. A parameter that is out of range is logged and
  /// reported in /diagnostics; the node then stays up without publishing.
  WrenchAdapterNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

 private:
  using Message = topic_tools::ShapeShifter;

  void ReadParameters();
  /// Makes the adapter and subscribes, if it can be made.
  void Start();
  /// Sets `urdf` to the robot's description. Returns whether there is a new one.
  bool FindDescription(std::string* urdf);
  void OnDriver(const Message::ConstPtr& message);
  void OnJointStates(const Message::ConstPtr& message);
  void Report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  WrenchAdapterOptions options_;
  std::unique_ptr<WrenchAdapter> adapter_;  ///< null while the robot's description is missing
  std::string description_;                 ///< the last one that was tried
  std::string parameter_faults_;
  std::string arm_fault_;    ///< why there is no adapter; empty if there is one
  std::string fault_;        ///< why the last message gave no wrench; empty if it did
  std::string joint_fault_;  ///< why the last joint states gave no positions; empty if they did
  int published_ = 0;
  ros::SteadyTime last_message_;  ///< zero before there was one

  ros::Publisher wrench_publisher_;
  ros::Subscriber driver_subscriber_;
  ros::Subscriber joint_subscriber_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
};

}  // namespace contact_shapelets
