#include "contact_shapelets/ros/wrench_adapter_node.h"

#include <stdexcept>

#include "contact_shapelets/ros/parameters.h"
#include "contact_shapelets/ros/topics.h"
#include "ros/text.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr Eigen::Index kJoints = 7;

Eigen::VectorXd JointValues(const std::vector<double>& values, const std::string& what) {
  if (values.size() != kJoints) {
    throw std::runtime_error(what + " has " + std::to_string(values.size()) + " values, expected 7");
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), kJoints);
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
  std::vector<double> lengths{geometry_.base_to_shoulder, geometry_.shoulder_to_elbow, geometry_.elbow_to_wrist,
                              geometry_.wrist_to_flange};
  reader.Read("source", {{"wrench", false}, {"joint_torques", true}}, &from_torques_);
  reader.Read("field", &field_);
  reader.Read("frame_id", &frame_id_);
  reader.Read("damping", &damping_);
  reader.Read("arm_lengths", &lengths);
  if (!(damping_ >= 0.0)) reader.AddFaults("damping must be at least 0, but is " + std::to_string(damping_) + "\n");
  for (const double length : lengths) {
    if (!(length > 0.0)) reader.AddFaults("arm_lengths must be above 0 m, but one is " + std::to_string(length) + "\n");
  }
  if (lengths.size() == 4) {
    geometry_ = {lengths[0], lengths[1], lengths[2], lengths[3]};
  } else {
    reader.AddFaults("arm_lengths must be 4 lengths [m], but has " + std::to_string(lengths.size()) + "\n");
  }
  if (from_torques_ && field_.empty()) field_ = "external_torques.data";
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (!parameter_faults_.empty()) {
    ROS_ERROR("No wrench is published until these parameters are mended and the node is started again: %s",
              parameter_faults_.c_str());
  }
}

void WrenchAdapterNode::OnDriver(const Message::ConstPtr& message) {
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
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(5.0, "%s: %s", joint_subscriber_.getTopic().c_str(), error.what());
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
  if (joint_states_.empty()) throw std::runtime_error("no message yet on " + joint_subscriber_.getTopic());
  return core::FlangeWrench(geometry_, JointValues(joint_states_.Numbers("position"), "position"),
                            JointValues(driver_.Numbers(field_), field_), damping_);
}

void WrenchAdapterNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!parameter_faults_.empty()) {
    status.summary(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
  } else if (!fault_.empty()) {
    status.summary(DiagnosticStatus::ERROR, fault_);
  } else if (published_ == 0) {
    status.summary(DiagnosticStatus::WARN, "no message yet on " + driver_subscriber_.getTopic());
  } else {
    status.summary(DiagnosticStatus::OK, "wrench is published");
  }
  status.add("published", published_);
}

}  // namespace contact_shapelets
