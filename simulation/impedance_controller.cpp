#include "impedance_controller.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace contact_shapelets::simulation {
namespace {

constexpr double kElbowStiffness = 20.0;  // [Nm/rad]
constexpr double kElbowDamping = 5.0;     // [Nm s/rad]

}  // namespace

void ImpedanceController::Design(const CellModel& cell) {
  const JointMatrix inverse_mass = cell.MassMatrix().llt().solve(JointMatrix::Identity());
  const Jacobian jacobian = cell.TipJacobian();
  const Matrix6 mobility = jacobian * inverse_mass * jacobian.transpose();
  const Matrix6 inertia = mobility.llt().solve(Matrix6::Identity());
  const Matrix6 root = Eigen::SelfAdjointEigenSolver<Matrix6>(0.5 * (inertia + inertia.transpose())).operatorSqrt();
  Vector6 stiffness;
  stiffness << Eigen::Vector3d::Constant(impedance_.stiffness),
      Eigen::Vector3d::Constant(impedance_.rotational_stiffness);
  const Matrix6 stiffness_root = stiffness.cwiseSqrt().asDiagonal();
  damping_ = impedance_.damping_ratio * (root * stiffness_root + stiffness_root * root);
  null_space_ = JointMatrix::Identity() - jacobian.transpose() * inertia * jacobian * inverse_mass;
}

JointVector ImpedanceController::Torques(const CellModel& cell, const MotionReference& reference) const {
  const Pose tip = cell.Tip();
  const Jacobian jacobian = cell.TipJacobian();
  const JointVector speeds = cell.JointSpeeds();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  const Eigen::Matrix3d wanted = CellModel::ToolOrientation();
  for (int axis = 0; axis < 3; ++axis) turn += 0.5 * tip.orientation.col(axis).cross(wanted.col(axis));
  Vector6 spring;
  spring << impedance_.stiffness * (reference.position - tip.position), impedance_.rotational_stiffness * turn;
  Vector6 velocity_error = -jacobian * speeds;
  velocity_error.head<3>() += reference.velocity;
  const JointVector elbow = kElbowStiffness * (elbow_ - cell.JointAngles()) - kElbowDamping * speeds;
  return Eigen::Map<const JointVector>(cell.data()->qfrc_bias) +
         jacobian.transpose() * (spring + damping_ * velocity_error) + null_space_ * elbow;
}

}  // namespace contact_shapelets::simulation
