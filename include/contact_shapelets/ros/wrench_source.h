#pragma once

#include <string>

/// \file
/// Where the wrench comes from, if a driver does not publish it as geometry_msgs/WrenchStamped.

namespace contact_shapelets {

/// What a driver's messages hold, and in which field.
struct WrenchAdapterOptions {
  bool from_torques = false;  ///< the messages hold external torques of joints, not a wrench
  std::string field;      ///< path of the numbers; if empty, the first geometry_msgs/Wrench, or external_torques.data
  std::string frame_id;   ///< frame of the wrench; if empty, the message's, or tip_link for torques
  double damping = 0.05;  ///< damping of the pseudo-inverse near singular poses, [0, 100]
  std::string base_link;  ///< for torques: the first link of the arm in the URDF
  std::string tip_link;   ///< for torques: the link in the URDF at which the wrench acts

  /// Returns one line for each option that is out of range; an empty string if all are valid.
  std::string Faults() const;
};

/// The same for a bag, which has no parameter server.
struct WrenchSource {
  WrenchAdapterOptions adapter;                ///< how to convert the messages of the wrench's topic
  std::string urdf;                            ///< for torques: the text of the robot's description
  std::string joint_states = "/joint_states";  ///< for torques: the topic of the joints' positions
};

}  // namespace contact_shapelets
