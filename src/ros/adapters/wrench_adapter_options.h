#pragma once

#include <string>

namespace contact_shapelets {

/// What a driver's messages hold, and where.
struct WrenchAdapterOptions {
  bool from_torques = false;  ///< the messages hold external torques of joints, not a wrench
  std::string field;          ///< path of the numbers; empty: the first geometry_msgs/Wrench, or external_torques.data
  std::string frame_id;       ///< of the wrench; empty: the message's, or tip_link for torques
  double damping = 0.05;      ///< of the pseudo-inverse near singular poses, [0, 100]
  std::string base_link;      ///< for torques: the link of the URDF that the arm stands on
  std::string tip_link;       ///< for torques: the link of the URDF at which the wrench is given

  /// Every option that is out of range, one line each; empty if all are valid.
  std::string Faults() const;
};

}  // namespace contact_shapelets
