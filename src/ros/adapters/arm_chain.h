#pragma once

#include <Eigen/Core>
#include <kdl/chain.hpp>
#include <string>
#include <vector>

/// \file
/// Computes the wrench at the tip of an arm from the external torques of its joints, for drivers that publish no
/// wrench.

namespace contact_shapelets {

/// A force and a torque at one point.
struct Wrench {
  Eigen::Vector3d force;   ///< [N]
  Eigen::Vector3d torque;  ///< [Nm]
};

/// The joints of an arm from its base to its tip, as the URDF of the robot describes them.
class ArmChain {
 public:
  /// Takes the joints between two links of `urdf` (the text of a URDF file).
  /// \throws std::runtime_error if the text is no URDF, has no such link, or has no joint that moves between the two.
  ArmChain(const std::string& urdf, const std::string& base_link, const std::string& tip_link);

  /// Names of the joints that move, from base to tip.
  const std::vector<std::string>& joint_names() const { return joint_names_; }

  /// Returns the wrench W that the surroundings exert on the tip link at its origin, in its axes: the damped least
  /// squares solution (J J^T + damping^2 I)^-1 J tau of J^T W = tau, where J is the geometric Jacobian of the tip.
  /// `positions` [rad; m for a prismatic joint] and `torques` [Nm; N] have one value for each joint, in the order of
  /// joint_names(); `damping` is at least 0 and bounds the wrench near singular poses.
  Wrench WrenchAtTip(const Eigen::Ref<const Eigen::VectorXd>& positions,
                     const Eigen::Ref<const Eigen::VectorXd>& torques, double damping) const;

 private:
  KDL::Chain chain_;
  std::vector<std::string> joint_names_;
};

}  // namespace contact_shapelets
