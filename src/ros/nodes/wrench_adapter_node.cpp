#include "ros/nodes/wrench_adapter_node.h"

#include <iomanip>
#include <sstream>

#include "ros/messages/names.h"
#include "ros/messages/text.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr char kRobotDescription[] = "robot_description";
/// [s] A driver counts as gone after this time without a message.
constexpr double kSilence = 1.0;

std::string Silence(double seconds, const std::string& topic) {
  std::ostringstream text;
  text << "no message for " << std::fixed << std::setprecision(1) << seconds << " s on " << topic;
  return text.str();
}

}  // namespace

WrenchAdapterNode::WrenchAdapterNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ReadParameters();
  wrench_publisher_ = node_handle_.advertise<geometry_msgs::WrenchStamped>(topics::kWrench, topics::kWrenchQueue);
  if (parameter_faults_.empty()) Start();
  updater_.setHardwareID("none");
  updater_.add("adapter", this, &WrenchAdapterNode::Report);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) {
    if (!adapter_ && parameter_faults_.empty()) Start();
    updater_.force_update();
  });
}

void WrenchAdapterNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  options_ = ReadAdapterOptions(&reader);
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (!parameter_faults_.empty()) {
    ROS_ERROR("This node publishes no wrench. Correct these parameters and start it again: %s",
              parameter_faults_.c_str());
  }
}

void WrenchAdapterNode::Start() {
  const std::string before = arm_fault_;
  try {
    std::string urdf;
    if (options_.from_torques && !FindDescription(&urdf)) return;
    adapter_ = std::make_unique<WrenchAdapter>(options_, urdf);
    arm_fault_.clear();
  } catch (const std::exception& error) {
    arm_fault_ = error.what();
    if (arm_fault_ != before)
      ROS_ERROR("This node publishes no wrench until this is corrected: %s", arm_fault_.c_str());
    return;
  }
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  driver_subscriber_ = node_handle_.subscribe<Message>(topics::kDriverMessage, topics::kWrenchQueue,
                                                       &WrenchAdapterNode::OnDriver, this, no_delay);
  if (options_.from_torques) {
    joint_subscriber_ = node_handle_.subscribe<Message>(topics::kJointStates, topics::kResultQueue,
                                                        &WrenchAdapterNode::OnJointStates, this, no_delay);
  }
}

bool WrenchAdapterNode::FindDescription(std::string* urdf) {
  std::string name;
  if (!private_node_handle_.searchParam(kRobotDescription, name) || !private_node_handle_.getParam(name, *urdf)) {
    throw std::runtime_error("the parameter robot_description is not set; it must hold the URDF of the robot");
  }
  const bool is_new = *urdf != description_;
  description_ = *urdf;
  return is_new;
}

void WrenchAdapterNode::OnDriver(const Message::ConstPtr& message) {
  last_message_ = ros::SteadyTime::now();
  try {
    wrench_publisher_.publish(adapter_->Convert(*message, ros::Time::now()));
    ++published_;
    fault_.clear();
  } catch (const std::exception& error) {
    fault_ = driver_subscriber_.getTopic() + ": " + error.what();
    ROS_ERROR_THROTTLE(5.0, "%s", fault_.c_str());
  }
}

void WrenchAdapterNode::OnJointStates(const Message::ConstPtr& message) {
  try {
    adapter_->TakeJointStates(*message, ros::Time::now());
    joint_fault_.clear();
  } catch (const std::exception& error) {
    joint_fault_ = joint_subscriber_.getTopic() + ": " + error.what();
    ROS_ERROR_THROTTLE(5.0, "%s", joint_fault_.c_str());
  }
}

void WrenchAdapterNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::string topic = node_handle_.resolveName(topics::kDriverMessage);
  const bool heard = !last_message_.isZero();
  const double silence = (ros::SteadyTime::now() - last_message_).toSec();
  std::string faults;
  for (const std::string& fault :
       {parameter_faults_.empty() ? "" : "parameters are out of range: " + parameter_faults_, arm_fault_, joint_fault_,
        fault_, heard && silence > kSilence ? Silence(silence, topic) : ""}) {
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
