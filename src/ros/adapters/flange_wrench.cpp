#include "ros/adapters/flange_wrench.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>

namespace contact_shapelets::core {
namespace {

constexpr int kJoints = 7;

}  // namespace

Wrench FlangeWrench(const ArmGeometry& geometry, const Eigen::Ref<const Eigen::VectorXd>& positions,
                    const Eigen::Ref<const Eigen::VectorXd>& torques, double damping) {
  const std::array<Eigen::Vector3d, kJoints> axes{
      Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(),
      Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  const std::array<double, kJoints> before{geometry.base_to_shoulder, 0.0, 0.0, geometry.shoulder_to_elbow, 0.0,
                                           geometry.elbow_to_wrist,   0.0};
  std::array<Eigen::Vector3d, kJoints> origins;
  std::array<Eigen::Vector3d, kJoints> directions;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    pose.translate(before[joint] * Eigen::Vector3d::UnitZ());
    origins[joint] = pose.translation();
    directions[joint] = pose.linear() * axes[joint];
    pose.rotate(Eigen::AngleAxisd(positions[static_cast<Eigen::Index>(joint)], axes[joint]));
  }
  pose.translate(geometry.wrist_to_flange * Eigen::Vector3d::UnitZ());

  Eigen::Matrix<double, 6, kJoints> jacobian;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const auto column = static_cast<Eigen::Index>(joint);
    jacobian.col(column) << directions[joint].cross(pose.translation() - origins[joint]), directions[joint];
  }
  const Eigen::Matrix<double, 6, 6> normal =
      jacobian * jacobian.transpose() + damping * damping * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 1> wrench = normal.ldlt().solve(jacobian * torques);
  return {pose.linear().transpose() * wrench.head<3>(), pose.linear().transpose() * wrench.tail<3>()};
}

}  // namespace contact_shapelets::core
