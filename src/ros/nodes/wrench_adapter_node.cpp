#include "ros/nodes/wrench_adapter_node.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "ros/messages/text.h"
#include "ros/messages/topics.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr Eigen::Index kJoints = 7;
/// [s] Torques are made a wrench by joint positions that are at most as much older or newer.
constexpr double kPositionAge = 0.2;
/// [s] A driver without a message for longer counts as gone.
constexpr double kSilence = 1.0;

Eigen::VectorXd JointValues(const std::vector<double>& values, const std::string& what) {
  if (values.size() != kJoints) {
    throw std::runtime_error(what + " has " + std::to_string(values.size()) + " values, expected 7");
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), kJoints);
}

std::string Tenths(double seconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << seconds << " s";
  return text.str();
}

}  // namespace

void WrenchAdapterNode::Reader::Take(const Message& message) {
  if (!definition_ || digest_ != message.getMD5Sum()) {
    definition_ = std::make_unique<MessageDefinition>(message.getDataType(), message.getMessageDefinition());
    digest_ = message.getMD5Sum();
    header_path_ = definition_->PathOf("std_msgs/Header");
  }
  bytes_.resize(message.size());
  ros::serialization::OStream stream(bytes_.data(), message.size());
  message.write(stream);
}

std::vector<double> WrenchAdapterNode::Reader::Numbers(const std::string& path) const {
  return definition_->Numbers(path, bytes_.data(), bytes_.size());
}

std_msgs::Header WrenchAdapterNode::Reader::Header() const {
  std_msgs::Header header;
  if (header_path_.empty()) return header;
  const std::vector<double> stamp = Numbers(header_path_ + ".stamp");
  header.stamp = ros::Time(static_cast<std::uint32_t>(stamp[0]), static_cast<std::uint32_t>(stamp[1]));
  header.frame_id = definition_->Text(header_path_ + ".frame_id", bytes_.data(), bytes_.size());
  return header;
}

WrenchAdapterNode::WrenchAdapterNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ReadParameters();
  wrench_publisher_ = node_handle_.advertise<geometry_msgs::WrenchStamped>(topics::kWrench, topics::kWrenchQueue);
  if (parameter_faults_.empty()) {
    const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
    driver_subscriber_ = node_handle_.subscribe<Message>(topics::kDriverMessage, topics::kWrenchQueue,
                                                         &WrenchAdapterNode::OnDriver, this, no_delay);
    if (from_torques_) {
      joint_subscriber_ = node_handle_.subscribe<Message>(topics::kJointStates, topics::kResultQueue,
                                                          &WrenchAdapterNode::OnJointStates, this, no_delay);
    }
  }
  updater_.setHardwareID("none");
  updater_.add("adapter", this, &WrenchAdapterNode::Report);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void WrenchAdapterNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  const AdapterOptions options = ReadAdapterOptions(&reader);
  from_torques_ = options.from_torques;
  field_ = options.field;
  frame_id_ = options.frame_id;
  damping_ = options.damping;
  const std::vector<double>& lengths = options.arm_lengths;
  if (lengths.size() == 4) geometry_ = {lengths[0], lengths[1], lengths[2], lengths[3]};
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (!parameter_faults_.empty()) {
    ROS_ERROR("No wrench is published until these parameters are mended and the node is started again: %s",
              parameter_faults_.c_str());
  }
}

void WrenchAdapterNode::OnDriver(const Message::ConstPtr& message) {
  last_message_ = ros::SteadyTime::now();
  try {
    const core::Wrench wrench = WrenchOf(*message);
    geometry_msgs::WrenchStamped output;
    output.header = driver_.Header();
    if (!frame_id_.empty()) output.header.frame_id = frame_id_;
    output.wrench.force.x = wrench.force.x();
    output.wrench.force.y = wrench.force.y();
    output.wrench.force.z = wrench.force.z();
    output.wrench.torque.x = wrench.torque.x();
    output.wrench.torque.y = wrench.torque.y();
    output.wrench.torque.z = wrench.torque.z();
    wrench_publisher_.publish(output);
    ++published_;
    fault_.clear();
  } catch (const std::exception& error) {
    fault_ = driver_subscriber_.getTopic() + ": " + error.what();
    ROS_ERROR_THROTTLE(5.0, "%s", fault_.c_str());
  }
}

void WrenchAdapterNode::OnJointStates(const Message::ConstPtr& message) {
  try {
    joint_states_.Take(*message);
    positions_ = JointValues(joint_states_.Numbers("position"), "position");
    positions_stamp_ = joint_states_.Header().stamp;
    positions_arrival_ = ros::Time::now();
    joint_fault_.clear();
  } catch (const std::exception& error) {
    joint_fault_ = joint_subscriber_.getTopic() + ": " + error.what();
    ROS_ERROR_THROTTLE(5.0, "%s", joint_fault_.c_str());
  }
}

core::Wrench WrenchAdapterNode::WrenchOf(const Message& message) {
  driver_.Take(message);
  if (from_torques_) return WrenchOfTorques();
  const std::string path = field_.empty() ? driver_.PathOf("geometry_msgs/Wrench") : field_;
  if (path.empty()) {
    throw std::runtime_error(message.getDataType() + " holds no geometry_msgs/Wrench; name its six numbers by ~field");
  }
  const std::vector<double> values = driver_.Numbers(path);
  if (values.size() != 6) {
    throw std::runtime_error(path + " has " + std::to_string(values.size()) + " values, expected 6: force and torque");
  }
  return {{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
}

core::Wrench WrenchAdapterNode::WrenchOfTorques() {
  if (positions_.size() == 0) throw std::runtime_error("no positions yet on " + joint_subscriber_.getTopic());
  const ros::Time stamp = driver_.Header().stamp;
  const bool stamped = !stamp.isZero() && !positions_stamp_.isZero();
  const double age =
      stamped ? stamp.toSec() - positions_stamp_.toSec() : ros::Time::now().toSec() - positions_arrival_.toSec();
  if (std::abs(age) > kPositionAge) {
    throw std::runtime_error("the last position on " + joint_subscriber_.getTopic() + " is " + Tenths(std::abs(age)) +
                             (age > 0.0 ? " older" : " newer") + " than the torques, more than " +
                             Tenths(kPositionAge));
  }
  return core::FlangeWrench(geometry_, positions_, JointValues(driver_.Numbers(field_), field_), damping_);
}

void WrenchAdapterNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::string topic = driver_subscriber_.getTopic();
  const bool heard = !last_message_.isZero();
  const double silence = (ros::SteadyTime::now() - last_message_).toSec();
  std::string faults;
  for (const std::string& fault :
       {parameter_faults_.empty() ? "" : "parameters are out of range: " + parameter_faults_, joint_fault_, fault_,
        heard && silence > kSilence ? "no message for " + Tenths(silence) + " on " + topic : ""}) {
    if (!fault.empty()) faults += (faults.empty() ? "" : "; ") + fault;
  }
  if (!faults.empty()) {
    status.summary(DiagnosticStatus::ERROR, faults);
  } else if (!heard) {
    status.summary(DiagnosticStatus::WARN, "no message yet on " + topic);
  } else {
    status.summary(DiagnosticStatus::OK, "wrench is published");
  }
  status.add("published", published_);
  if (heard) status.add("time since the last message [s]", silence);
}

}  // namespace contact_shapelets
