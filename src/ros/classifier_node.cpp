#include "contact_shapelets/ros/classifier_node.h"

#include <std_msgs/String.h>

#include <utility>

#include "contact_shapelets/ros/conversions.h"
#include "contact_shapelets/ros/model_bag.h"
#include "contact_shapelets/ros/topics.h"

namespace contact_shapelets {

using diagnostic_msgs::DiagnosticStatus;

ClassifierNode::ClassifierNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ParameterReader reader(private_node_handle_);
  options_ = ReadClassifierOptions(&reader);
  for (const std::string& name : reader.Unread()) ROS_WARN("~%s is not a parameter of this node", name.c_str());
  if (!reader.Faults().empty()) {
    fault_ = "parameters: " + reader.Faults();
    ROS_ERROR("Parameters that are out of range have their defaults instead:\n%s", reader.Faults().c_str());
    const std::string model = std::exchange(options_, ClassifierOptions{}).model;
    options_.model = model;
  }

  features_publisher_ = node_handle_.advertise<ShapeletFeatures>(topics::kFeatures, topics::kResultQueue);
  diagnosis_publisher_ = node_handle_.advertise<contact_shapelets::Diagnosis>(topics::kDiagnosis, topics::kResultQueue);
  event_publisher_ = node_handle_.advertise<std_msgs::String>(topics::kEvent, topics::kResultQueue);
  LoadModelFile();

  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  model_subscriber_ = node_handle_.subscribe(topics::kModel, 1, &ClassifierNode::OnModel, this);
  episode_subscriber_ =
      node_handle_.subscribe(topics::kEpisode, topics::kResultQueue, &ClassifierNode::OnEpisode, this, no_delay);
  if (options_.early) {
    progress_subscriber_ = node_handle_.subscribe(topics::kEpisodeProgress, topics::kProgressQueue,
                                                  &ClassifierNode::OnProgress, this, no_delay);
  }
  name_service_ = private_node_handle_.advertiseService("name_cluster", &ClassifierNode::OnNameCluster, this);
  updater_.setHardwareID("none");
  updater_.add("model", this, &ClassifierNode::Report);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void ClassifierNode::LoadModelFile() {
  if (options_.model.empty()) return;
  try {
    classifier_ = std::make_unique<core::Classifier>(LoadModel(options_.model));
    model_from_file_ = true;
    ROS_INFO("Model %s out of %s", classifier_->model().id.c_str(), options_.model.c_str());
  } catch (const std::exception& error) {
    fault_ = error.what();
    ROS_ERROR("%s", error.what());
  }
}

void ClassifierNode::OnModel(const ShapeletModel& message) {
  try {
    classifier_ = std::make_unique<core::Classifier>(FromMessage(message));
    model_from_file_ = false;
    fault_.clear();
    ROS_INFO("Model %s by topic", message.model_id.c_str());
  } catch (const std::exception& error) {
    fault_ = std::string("a model by topic was refused: ") + error.what();
    ROS_ERROR("%s", fault_.c_str());
  }
}

void ClassifierNode::OnEpisode(const Episode& message) { Diagnose(message, true); }

void ClassifierNode::OnProgress(const Episode& message) {
  if (!classifier_) return;
  const double duration = message.sample_period * static_cast<double>(message.force.size());
  if (duration < options_.early_minimum * classifier_->model().provenance.typical_duration) return;
  Diagnose(message, false);
}

void ClassifierNode::Diagnose(const Episode& message, bool final) {
  if (!classifier_) {
    ROS_ERROR_THROTTLE(10.0, "Episode %s is not diagnosed: there is no model", message.episode_id.c_str());
    return;
  }
  try {
    const core::Episode episode = FromMessage(message);
    const core::Model& model = classifier_->model();
    const core::Classification result = classifier_->Classify(episode);
    diagnosis_publisher_.publish(DiagnosisMessage(episode, model, result.diagnosis, final));
    if (!final) return;
    std_msgs::String event;
    event.data = result.diagnosis.event;
    event_publisher_.publish(event);
    features_publisher_.publish(FeaturesMessage(episode, model, result.features));
    ++diagnosed_;
  } catch (const std::invalid_argument& error) {
    ++refused_;
    fault_ = "episode " + message.episode_id + ": " + error.what();
    ROS_ERROR("%s", fault_.c_str());
  }
}

bool ClassifierNode::OnNameCluster(NameCluster::Request& request, NameCluster::Response& response) {
  try {
    if (!classifier_) throw std::runtime_error("there is no model");
    classifier_->NameCluster(request.cluster, request.label);
    response.message = "cluster " + std::to_string(request.cluster) + " is " + request.label;
    if (model_from_file_) {
      SaveModel(options_.model, classifier_->model());
      response.message += ", saved in " + options_.model;
    } else {
      response.message += ", not saved: the model came by topic";
    }
    response.success = 1U;
  } catch (const std::exception& error) {
    response.message = error.what();
    ROS_ERROR("%s", error.what());
  }
  return true;
}

void ClassifierNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!classifier_) {
    status.summary(DiagnosticStatus::ERROR, fault_.empty() ? "no model yet" : fault_);
  } else if (!fault_.empty()) {
    status.summary(DiagnosticStatus::WARN, fault_);
  } else {
    status.summary(DiagnosticStatus::OK, "model in use");
  }
  if (classifier_) {
    status.add("model", classifier_->model().id);
    status.add("shapelets", classifier_->model().shapelets.size());
    status.add("clusters", classifier_->model().clusters.size());
  }
  status.add("episodes diagnosed", diagnosed_);
  status.add("episodes refused", refused_);
}

}  // namespace contact_shapelets
