#include "ros/adapters/arm_chain.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ros/adapters/robot_description.h"

namespace contact_shapelets {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector7 = Eigen::Matrix<double, 7, 1>;

ArmChain Iiwa(const std::string& file) { return {test::RobotDescription(file), "iiwa_link_0", "iiwa_link_ee"}; }

Vector7 Seven(const std::vector<double>& values) { return Eigen::Map<const Vector7>(values.data()); }

/// Upper arm level along x, forearm straight down: shoulder at (0, 0, 0.34), elbow at (0.4, 0, 0.34), wrist at (0.4, 0,
/// -0.06), flange at (0.4, 0, -0.186), its z down. The axes of the joints then are z, y, x, -y, -z, y, -z.
Vector7 BentArm() { return Seven({0.0, EIGEN_PI / 2.0, 0.0, -EIGEN_PI / 2.0, 0.0, 0.0, 0.0}); }

/// A sliding joint along -x, then a joint about y with a rod of 0.5 m along x.
std::string SlideAndRod(const std::string& second_type) {
  return R"(<robot name="slide_and_rod"><link name="base"/><link name="slide"/><link name="rod"/><link name="tip"/>
    <joint name="along" type="prismatic"><parent link="base"/><child link="slide"/><axis xyz="-1 0 0"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
    <joint name="about" type=")" +
         second_type + R"("><parent link="slide"/><child link="rod"/><axis xyz="0 1 0"/></joint>
    <joint name="end" type="fixed"><parent link="rod"/><child link="tip"/><origin xyz="0.5 0 0"/></joint></robot>)";
}

std::string FaultOf(const std::string& urdf, const std::string& base_link, const std::string& tip_link) {
  try {
    const ArmChain arm(urdf, base_link, tip_link);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ArmChain, GivesTheForceThatCausesTheTorques) {
  // A force (3, -2, 5) N at the flange, in the axes of the base: each joint's torque is axis . (lever x force).
  const Vector7 torques =
      Seven({0.4 * -2.0, -0.526 * 3.0 - 0.4 * 5.0, 0.526 * -2.0, 0.526 * 3.0, 0.0, -0.126 * 3.0, 0.0});
  const Wrench wrench = Iiwa("iiwa7.urdf").WrenchAtTip(BentArm(), torques, 0.0);
  // The flange is turned by half a turn about y.
  EXPECT_TRUE(wrench.force.isApprox(Eigen::Vector3d(-3.0, -2.0, -5.0), 1e-9)) << wrench.force.transpose();
  EXPECT_NEAR(wrench.torque.norm(), 0.0, 1e-9);
}

TEST(ArmChain, GivesTheTorqueThatCausesTheTorques) {
  // A torque (1, 2, 3) Nm at the flange, in the axes of the base.
  const Vector7 torques = Seven({3.0, 2.0, 1.0, -2.0, -3.0, 2.0, -3.0});
  const Wrench wrench = Iiwa("iiwa7.urdf").WrenchAtTip(BentArm(), torques, 0.0);
  EXPECT_TRUE(wrench.torque.isApprox(Eigen::Vector3d(-1.0, 2.0, -3.0), 1e-9)) << wrench.torque.transpose();
  EXPECT_NEAR(wrench.force.norm(), 0.0, 1e-9);
}

/// The wrench of a closed-form chain z, y, z, -y, z, y, z with an iiwa's dimensions, for torques (1.5, -2.25,
/// 0.75, 3.5, -0.5, 0.25, -1) Nm.
struct KnownWrench {
  const char* urdf;
  std::vector<double> positions;
  double damping;
  Vector6 wrench;
};

std::vector<KnownWrench> KnownWrenches() {
  const std::vector<double> near{0.3, -0.5, 0.7, -1.1, 0.4, 0.9, -0.6};
  const std::vector<double> far{-2.1, 1.3, -0.2, 1.7, 2.4, -1.5, 2.9};
  const std::vector<double> straight(7, 0.0);
  const auto six = [](double fx, double fy, double fz, double tx, double ty, double tz) {
    Vector6 wrench;
    wrench << fx, fy, fz, tx, ty, tz;
    return wrench;
  };
  return {
      {"iiwa7.urdf", near, 0.05,
       six(-8.6270880529078511, -3.2481848269681795, -2.471661666428405, -1.0292332292046851, 0.93315991467136072,
           -1.1446466016049612)},
      {"iiwa7.urdf", near, 0.0,
       six(-9.6002899988139738, -3.4935164347240404, -2.1806958650724559, -1.0614239806360402, 1.1352673383148202,
           -1.1189649799985428)},
      {"iiwa7.urdf", far, 0.05,
       six(2.2682117412207599, -6.6103879796549254, -6.8181236224829416, -1.1703691547677044, -0.035263104760222722,
           -0.28076476824054841)},
      {"iiwa7.urdf", straight, 0.05,
       six(-3.1015977306735483, 0.0, 0.0, 0.0, -0.20172482297989736, 0.18738288569643971)},
      {"iiwa14.urdf", near, 0.05,
       six(-8.5896605924040141, -3.2114381200741571, -2.5211871999858055, -1.0207460589572754, 0.93156833163948449,
           -1.1452686602776221)},
      {"iiwa14.urdf", near, 0.0,
       six(-9.5109594357744669, -3.441592441185668, -2.268595049360095, -1.0531350927644048, 1.1257510143605047,
           -1.1203219253775771)},
      {"iiwa14.urdf", far, 0.05,
       six(2.1237443005758769, -6.5249798779512345, -6.9165326351961163, -1.140447348868268, 0.0055306026979139583,
           -0.26163648510781151)},
      {"iiwa14.urdf", straight, 0.05,
       six(-2.977454796984508, 0.0, 0.0, 0.0, -0.24713646441923598, 0.18738288569643971)},
  };
}

TEST(ArmChain, GivesAnIiwa7AndAnIiwa14TheWrenchOfTheirClosedForm) {
  const Vector7 torques = Seven({1.5, -2.25, 0.75, 3.5, -0.5, 0.25, -1.0});
  for (const KnownWrench& known : KnownWrenches()) {
    const Wrench wrench = Iiwa(known.urdf).WrenchAtTip(Seven(known.positions), torques, known.damping);
    Vector6 found;
    found << wrench.force, wrench.torque;
    EXPECT_LT((found - known.wrench).cwiseAbs().maxCoeff(), 1e-9)
        << known.urdf << ", damping " << known.damping << ": " << found.transpose();
  }
}

TEST(ArmChain, StaysBoundedInASingularPose) {
  const Wrench wrench = Iiwa("iiwa7.urdf").WrenchAtTip(Vector7::Zero(), Vector7::Ones(), 0.05);
  EXPECT_LT(wrench.force.norm(), 20.0);
}

TEST(ArmChain, ServesAnArmWithASlideAndOtherAxes) {
  const ArmChain arm(SlideAndRod("continuous"), "base", "tip");
  EXPECT_EQ(arm.joint_names(), (std::vector<std::string>{"along", "about"}));
  // The rod points down after a quarter turn; 4 N along the base's x are -4 N on the slide and, by the lever (0, 0,
  // -0.5), -2 Nm about y. What no joint feels is zero.
  const Wrench wrench = arm.WrenchAtTip(Eigen::Vector2d(0.2, EIGEN_PI / 2.0), Eigen::Vector2d(-4.0, -2.0), 1e-6);
  // The tip's z is the base's x.
  EXPECT_NEAR(wrench.force.z(), 4.0, 1e-6) << wrench.force.transpose();
  EXPECT_NEAR(wrench.torque.norm(), 0.0, 1e-6);
}

TEST(ArmChain, LeavesOutJointsThatDoNotMove) {
  EXPECT_EQ(ArmChain(SlideAndRod("fixed"), "base", "tip").joint_names(), std::vector<std::string>{"along"});
}

TEST(ArmChain, SaysWhatTheDescriptionLacks) {
  const std::string iiwa = test::RobotDescription("iiwa7.urdf");
  EXPECT_EQ(FaultOf("no xml", "base", "tip"), "the robot's description is no valid URDF");
  EXPECT_EQ(FaultOf(iiwa, "iiwa_link_0", "tool"), "the robot's description has no link \"tool\"");
  EXPECT_EQ(FaultOf(iiwa, "base", "iiwa_link_ee"), "the robot's description has no link \"base\"");
  EXPECT_EQ(FaultOf(iiwa, "iiwa_link_7", "iiwa_link_ee"),
            "the robot's description has no joint that moves between iiwa_link_7 and iiwa_link_ee");
}

}  // namespace
}  // namespace contact_shapelets
