#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ros/adapters/flange_wrench.h"
#include "ros/messages/message_definition.h"

namespace contact_shapelets {

/// Publishes `wrench` for drivers that have it in a message of their own, or only the external torques of the joints.
/// Messages are read by the definition that comes with them, so that no driver's package is needed. Torques become a
/// wrench by joint positions that are at most 0.2 s older or newer, by the stamps where both have one, else by arrival:
/// the last pose of an arm that has gone on moving would give a wrench that nothing exerts. Its callbacks need a queue
/// that one thread serves.
class WrenchAdapterNode {
 public:
  /// Reads parameters from `private_node_handle` and subscribes. A parameter that is out of range is logged and
  /// reported in /diagnostics; the node then stays up without publishing.
  WrenchAdapterNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

 private:
  using Message = topic_tools::ShapeShifter;

  /// Takes messages of one topic apart, whatever their type.
  class Reader {
   public:
    /// Makes `message` the one that is read. \throws std::runtime_error where its definition cannot be understood.
    void Take(const Message& message);
    std::vector<double> Numbers(const std::string& path) const;
    /// The header of the message, empty where it has none.
    std_msgs::Header Header() const;
    std::string PathOf(const std::string& type) const { return definition_->PathOf(type); }

   private:
    std::string digest_;  ///< MD5 of the type that `definition_` describes
    std::unique_ptr<MessageDefinition> definition_;
    std::string header_path_;
    std::vector<std::uint8_t> bytes_;
  };

  void ReadParameters();
  void OnDriver(const Message::ConstPtr& message);
  void OnJointStates(const Message::ConstPtr& message);
  core::Wrench WrenchOf(const Message& message);
  core::Wrench WrenchOfTorques();
  void Report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  bool from_torques_ = false;
  std::string field_;
  std::string frame_id_;
  double damping_ = 0.05;
  core::ArmGeometry geometry_;
  std::string parameter_faults_;
  std::string fault_;        ///< why the last message gave no wrench; empty where it did
  std::string joint_fault_;  ///< why the last joint states gave no positions; empty where they did
  int published_ = 0;
  Reader driver_;
  Reader joint_states_;
  ros::SteadyTime last_message_;  ///< zero before there was one
  Eigen::VectorXd positions_;     ///< [rad] empty before there were any
  ros::Time positions_stamp_;     ///< zero where they have none
  ros::Time positions_arrival_;

  ros::Publisher wrench_publisher_;
  ros::Subscriber driver_subscriber_;
  ros::Subscriber joint_subscriber_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
};

}  // namespace contact_shapelets
