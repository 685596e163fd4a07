#include "ros/adapters/wrench_adapter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "core/numerics/interval.h"

namespace contact_shapelets {
namespace {

/// [s] Greatest difference in time between torques and the joint positions that go with them.
constexpr double kPositionAge = 0.2;

std::string Tenths(double seconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << seconds << " s";
  return text.str();
}

std::string List(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Returns true if no name is that of a joint of the arm. A gripper may share the arm's topic.
bool AreOfAnotherDevice(const ArmChain& arm, const std::vector<std::string>& names) {
  const std::vector<std::string>& joints = arm.joint_names();
  return !names.empty() && std::none_of(names.begin(), names.end(), [&joints](const std::string& name) {
    return std::find(joints.begin(), joints.end(), name) != joints.end();
  });
}

/// Returns the values of the arm's joints in the arm's order. `names` has the joint of each value; if it is empty, the
/// values are in the arm's order already.
Eigen::VectorXd InArmOrder(const ArmChain& arm, const std::vector<std::string>& names,
                           const std::vector<double>& values, const std::string& what) {
  const std::vector<std::string>& joints = arm.joint_names();
  const std::size_t expected = names.empty() ? joints.size() : names.size();
  if (values.size() != expected) {
    throw std::runtime_error(what + " has " + std::to_string(values.size()) + " values, expected " +
                             std::to_string(expected));
  }
  if (names.empty()) return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  Eigen::VectorXd ordered(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto found = std::find(names.begin(), names.end(), joints[joint]);
    if (found == names.end()) {
      throw std::runtime_error("joint " + joints[joint] +
                               " of the robot's description is not among the names: " + List(names));
    }
    ordered[static_cast<Eigen::Index>(joint)] = values[static_cast<std::size_t>(found - names.begin())];
  }
  return ordered;
}

}  // namespace

std::string WrenchAdapterOptions::Faults() const {
  std::ostringstream faults;
  core::CheckRange("damping", damping, {0, 100}, &faults);
  if (from_torques && base_link.empty()) faults << "base_link must name a link of the robot, but is empty\n";
  if (from_torques && tip_link.empty()) faults << "tip_link must name a link of the robot, but is empty\n";
  return faults.str();
}

WrenchAdapter::WrenchAdapter(const WrenchAdapterOptions& options, const std::string& urdf) : options_(options) {
  if (!options_.from_torques) return;
  arm_.emplace(urdf, options_.base_link, options_.tip_link);
  if (options_.field.empty()) options_.field = "external_torques.data";
  if (options_.frame_id.empty()) options_.frame_id = options_.tip_link;
}

void WrenchAdapter::ReadPositions(const ros::Time& arrival) {
  if (!arm_) return;
  const std::vector<std::string> names = joint_states_.TextsIfAny("name");
  if (AreOfAnotherDevice(*arm_, names)) return;
  positions_ = InArmOrder(*arm_, names, joint_states_.Numbers("position"), "position");
  positions_stamp_ = joint_states_.Header().stamp;
  positions_arrival_ = arrival;
}

geometry_msgs::WrenchStamped WrenchAdapter::Convert(const ros::Time& arrival) const {
  const Wrench wrench = arm_ ? WrenchOfTorques(arrival) : ReadWrench();
  geometry_msgs::WrenchStamped output;
  output.header = driver_.Header();
  if (!options_.frame_id.empty()) output.header.frame_id = options_.frame_id;
  output.wrench.force.x = wrench.force.x();
  output.wrench.force.y = wrench.force.y();
  output.wrench.force.z = wrench.force.z();
  output.wrench.torque.x = wrench.torque.x();
  output.wrench.torque.y = wrench.torque.y();
  output.wrench.torque.z = wrench.torque.z();
  return output;
}

Wrench WrenchAdapter::ReadWrench() const {
  const std::string path = options_.field.empty() ? driver_.PathOf("geometry_msgs/Wrench") : options_.field;
  if (path.empty()) {
    throw std::runtime_error(driver_.datatype() + " holds no geometry_msgs/Wrench; name its six numbers by `field`");
  }
  const std::vector<double> values = driver_.Numbers(path);
  if (values.size() != 6) {
    throw std::runtime_error(path + " has " + std::to_string(values.size()) + " values, expected 6: force and torque");
  }
  return {{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
}

Wrench WrenchAdapter::WrenchOfTorques(const ros::Time& arrival) const {
  if (positions_.size() == 0) throw std::runtime_error("no joint states yet of " + List(arm_->joint_names()));
  const ros::Time stamp = driver_.Header().stamp;
  const bool stamped = !stamp.isZero() && !positions_stamp_.isZero();
  const double age = stamped ? stamp.toSec() - positions_stamp_.toSec() : arrival.toSec() - positions_arrival_.toSec();
  if (std::abs(age) > kPositionAge) {
    throw std::runtime_error("the last joint states are " + Tenths(std::abs(age)) + (age > 0.0 ? " older" : " newer") +
                             " than the torques, more than " + Tenths(kPositionAge));
  }
  const Eigen::VectorXd torques =
      InArmOrder(*arm_, driver_.TextsIfAny("name"), driver_.Numbers(options_.field), options_.field);
  return arm_->WrenchAtTip(positions_, torques, options_.damping);
}

}  // namespace contact_shapelets
