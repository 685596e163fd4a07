#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <memory>
#include <string>

#include "ros/adapters/wrench_adapter.h"

namespace contact_shapelets {

/// Publishes `wrench` for drivers that publish it in another type, or publish only the external torques of the joints.
/// WrenchAdapter converts the messages. For torques the node needs the parameter `robot_description`: it searches its
/// own namespace and those above until the parameter is set. Only one thread may serve its callbacks.
class WrenchAdapterNode {
 public:
  /// Reads parameters from `private_node_handle` and subscribes. Logs parameters that are out of range and reports them
  /// in /diagnostics. The node then stays up, but publishes no wrench.
  WrenchAdapterNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

 private:
  using Message = topic_tools::ShapeShifter;

  void ReadParameters();
  /// Makes the adapter and subscribes. Does nothing while the robot's description is missing or wrong.
  void Start();
  /// Sets `urdf` to the robot's description. Returns true if it is new.
  bool FindDescription(std::string* urdf);
  void OnDriver(const Message::ConstPtr& message);
  void OnJointStates(const Message::ConstPtr& message);
  void Report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  WrenchAdapterOptions options_;
  std::unique_ptr<WrenchAdapter> adapter_;  ///< null while the robot's description is missing
  std::string description_;                 ///< the last one that the node tried
  std::string parameter_faults_;
  std::string arm_fault_;    ///< why there is no adapter; empty if there is one
  std::string fault_;        ///< why the last message gave no wrench; empty if it did
  std::string joint_fault_;  ///< why the last joint states gave no positions; empty if they did
  int published_ = 0;
  ros::SteadyTime last_message_;  ///< zero before the first

  ros::Publisher wrench_publisher_;
  ros::Subscriber driver_subscriber_;
  ros::Subscriber joint_subscriber_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
};

}  // namespace contact_shapelets
