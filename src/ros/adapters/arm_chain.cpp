#include "ros/adapters/arm_chain.h"

#include <Eigen/Cholesky>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/tree.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <stdexcept>

namespace contact_shapelets {

ArmChain::ArmChain(const std::string& urdf, const std::string& base_link, const std::string& tip_link) {
  KDL::Tree tree;
  if (!kdl_parser::treeFromString(urdf, tree)) throw std::runtime_error("the robot's description is no valid URDF");
  for (const std::string& link : {base_link, tip_link}) {
    if (tree.getSegments().count(link) == 0) {
      throw std::runtime_error("the robot's description has no link \"" + link + "\"");
    }
  }
  if (!tree.getChain(base_link, tip_link, chain_) || chain_.getNrOfJoints() == 0) {
    throw std::runtime_error("the robot's description has no joint that moves between " + base_link + " and " +
                             tip_link);
  }
  for (const KDL::Segment& segment : chain_.segments) {
    if (segment.getJoint().getType() != KDL::Joint::None) joint_names_.push_back(segment.getJoint().getName());
  }
}

Wrench ArmChain::WrenchAtTip(const Eigen::Ref<const Eigen::VectorXd>& positions,
                             const Eigen::Ref<const Eigen::VectorXd>& torques, double damping) const {
  KDL::JntArray joints(chain_.getNrOfJoints());
  joints.data = positions;
  KDL::Jacobian jacobian(chain_.getNrOfJoints());
  KDL::Frame tip;
  if (KDL::ChainJntToJacSolver(chain_).JntToJac(joints, jacobian) < 0 ||
      KDL::ChainFkSolverPos_recursive(chain_).JntToCart(joints, tip) < 0) {
    throw std::runtime_error("KDL could not solve the kinematics of the arm");
  }
  // The wrench is in the axes of the tip, about its origin.
  jacobian.changeBase(tip.M.Inverse());
  const Eigen::Matrix<double, 6, 6> normal =
      jacobian.data * jacobian.data.transpose() + damping * damping * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 1> wrench = normal.ldlt().solve(jacobian.data * torques);
  return {wrench.head<3>(), wrench.tail<3>()};
}

}  // namespace contact_shapelets
