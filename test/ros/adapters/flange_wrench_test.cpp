#include "ros/adapters/flange_wrench.h"

#include <gtest/gtest.h>

namespace contact_shapelets::core {
namespace {

/// Upper arm level along x, forearm straight down: shoulder at (0, 0, 0.34), elbow at (0.4, 0, 0.34), wrist at (0.4, 0,
/// -0.06), flange at (0.4, 0, -0.186), its z down. The axes of the joints then are z, y, x, -y, -z, y, -z.
Eigen::VectorXd BentArm() {
  Eigen::VectorXd positions = Eigen::VectorXd::Zero(7);
  positions[1] = EIGEN_PI / 2.0;
  positions[3] = -EIGEN_PI / 2.0;
  return positions;
}

TEST(FlangeWrench, IsTheForceThatCausesTheTorques) {
  // A force of (3, -2, 5) N at the flange, in the base's axes. Each joint's torque is axis . (lever x force).
  Eigen::VectorXd torques(7);
  torques << 0.4 * -2.0, -0.526 * 3.0 - 0.4 * 5.0, 0.526 * -2.0, 0.526 * 3.0, 0.0, -0.126 * 3.0, 0.0;
  const Wrench wrench = FlangeWrench(ArmGeometry(), BentArm(), torques, 0.0);
  // The flange is half a turn about y from the base.
  EXPECT_TRUE(wrench.force.isApprox(Eigen::Vector3d(-3.0, -2.0, -5.0), 1e-9)) << wrench.force.transpose();
  EXPECT_NEAR(wrench.torque.norm(), 0.0, 1e-9);
}

TEST(FlangeWrench, IsTheTorqueThatCausesTheTorques) {
  // A torque of (1, 2, 3) Nm at the flange, in the base's axes.
  Eigen::VectorXd torques(7);
  torques << 3.0, 2.0, 1.0, -2.0, -3.0, 2.0, -3.0;
  const Wrench wrench = FlangeWrench(ArmGeometry(), BentArm(), torques, 0.0);
  EXPECT_TRUE(wrench.torque.isApprox(Eigen::Vector3d(-1.0, 2.0, -3.0), 1e-9)) << wrench.torque.transpose();
  EXPECT_NEAR(wrench.force.norm(), 0.0, 1e-9);
}

TEST(FlangeWrench, StaysBoundedInASingularPose) {
  const Wrench wrench = FlangeWrench(ArmGeometry(), Eigen::VectorXd::Zero(7), Eigen::VectorXd::Constant(7, 1.0), 0.05);
  EXPECT_LT(wrench.force.norm(), 20.0);
}

}  // namespace
}  // namespace contact_shapelets::core
