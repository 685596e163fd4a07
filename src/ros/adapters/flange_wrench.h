#pragma once

#include <Eigen/Core>

/// \file
/// The wrench at the flange of an arm from the external torques of its joints, for drivers that publish only these.

namespace contact_shapelets::core {

/// An arm of seven revolute joints in the order of a KUKA LBR iiwa: stretched out along z at zero, the axes are
/// z, y, z, -y, z, y, z. Defaults are the LBR iiwa 7 R800's (KUKA, Spez LBR iiwa, dimensions).
struct ArmGeometry {
  double base_to_shoulder = 0.34;  ///< [m]
  double shoulder_to_elbow = 0.4;  ///< [m]; 0.42 for the LBR iiwa 14 R820, whose base_to_shoulder is 0.36
  double elbow_to_wrist = 0.4;     ///< [m]
  double wrist_to_flange = 0.126;  ///< [m]
};

/// A force and a torque at one point.
struct Wrench {
  Eigen::Vector3d force;   ///< [N]
  Eigen::Vector3d torque;  ///< [Nm]
};

/// The wrench W that the surroundings exert on the flange, in the flange's axes: the damped least squares solution
/// (J J^T + damping^2 I)^-1 J tau of J^T W = tau, where J is the geometric Jacobian of the flange.
/// `positions` [7, rad], `torques` [7, Nm], `damping` at least 0 (it bounds the wrench near singular poses).
Wrench FlangeWrench(const ArmGeometry& geometry, const Eigen::Ref<const Eigen::VectorXd>& positions,
                    const Eigen::Ref<const Eigen::VectorXd>& torques, double damping);

}  // namespace contact_shapelets::core
