#include "ros/nodes/classifier_node.h"

#include <std_msgs/String.h>

#include <algorithm>
#include <utility>

#include "contact_shapelets/ros/model_bag.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/text.h"

namespace contact_shapelets {

namespace {

/// [s] Longer ones are refused anyway.
constexpr double kLongest = 1e8;

core::Nanoseconds EndOf(const Episode& message) {
  const double duration = message.sample_period * static_cast<double>(message.force.size());
  const bool sound = duration >= 0.0 && duration <= kLongest;
  return ToNanoseconds(message.header.stamp) + (sound ? core::FromSeconds(duration) : 0);
}

std::string ChangeText(const core::RunChange& change) {
  return "since about episode " + change.episode + " " + change.text;
}

}  // namespace

using diagnostic_msgs::DiagnosticStatus;

ClassifierNode::ClassifierNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ReadParameters();
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
  name_service_ = private_node_handle_.advertiseService(services::kNameCluster, &ClassifierNode::OnNameCluster, this);
  updater_.setHardwareID("none");
  updater_.add("model", this, &ClassifierNode::Report);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void ClassifierNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  options_ = ReadClassifierOptions(&reader);
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  model_is_relative_ = !options_.model.empty() && options_.model.front() != '/';
  options_.model = AbsolutePath(options_.model);
  if (parameter_faults_.empty()) return;
  ROS_ERROR("Defaults replace these parameters, which are out of range: %s", parameter_faults_.c_str());
  ClassifierOptions defaults;
  defaults.model = options_.model;
  options_ = defaults;
}

void ClassifierNode::LoadModelFile() {
  if (options_.model.empty()) return;
  try {
    Use(LoadModel(options_.model));
    ROS_INFO("Loaded model %s from %s", classifier_->model().id.c_str(), options_.model.c_str());
  } catch (const std::exception& error) {
    model_fault_ = OneLine(error.what());
    // roslaunch starts nodes in ~/.ros.
    if (model_is_relative_) model_fault_ += "; expected an absolute path in ~model";
    ROS_ERROR("%s", model_fault_.c_str());
  }
}

void ClassifierNode::Use(core::Model model) {
  classifier_ = std::make_unique<core::Classifier>(std::move(model));
  monitor_.reset();
  if (options_.change_reference == 0) return;
  core::ChangeOptions change;
  change.false_alarm_probability = options_.change_false_alarms;
  monitor_.emplace(options_.change_reference, change);
}

void ClassifierNode::WatchForChange(const core::Episode& episode, const core::Diagnosis& diagnosis) {
  // Half an episode has another duration and other forces.
  if (!monitor_ || !episode.complete) return;
  const bool told = monitor_->change().has_value();
  monitor_->Append(episode, diagnosis, classifier_->model());
  if (!told && monitor_->change()) ROS_WARN("%s", ChangeText(*monitor_->change()).c_str());
}

void ClassifierNode::OnModel(const ShapeletModel& message) {
  if (classifier_ && classifier_->model().id == message.model_id) return TakeNames(message);
  // A trainer's latched model may be older than the loaded file.
  if (classifier_ && ToNanoseconds(message.header.stamp) < classifier_->model().provenance.trained) {
    model_fault_ =
        "model " + message.model_id +
        " from the topic was refused: it is older than the one in use; to use it, start this node with its file";
    ROS_WARN("%s", model_fault_.c_str());
    return;
  }
  try {
    Use(FromMessage(message));
    model_fault_.clear();
    ROS_INFO("Took model %s from the topic", message.model_id.c_str());
  } catch (const std::exception& error) {
    model_fault_ = "a model from the topic was refused: " + OneLine(error.what());
    ROS_ERROR("%s", model_fault_.c_str());
  }
}

void ClassifierNode::TakeNames(const ShapeletModel& message) {
  model_fault_.clear();
  const std::size_t count = std::min(message.cluster_labels.size(), classifier_->model().clusters.size());
  for (std::size_t index = 0; index < count; ++index) {
    // The trainer's latched model lacks the names that this node gave.
    const std::string& name = message.cluster_labels[index];
    const bool sound = !name.empty() && name.size() <= core::kLongestLabel;
    if (!sound || !classifier_->model().clusters[index].label.empty()) continue;
    classifier_->NameCluster(static_cast<int>(index), name);
  }
}

void ClassifierNode::OnEpisode(const Episode& message) {
  last_episode_ = message.episode_id;
  last_end_ = EndOf(message);
  Diagnose(message, true);
}

void ClassifierNode::OnProgress(const Episode& message) {
  // Progress comes on another connection than episodes and may arrive after the end of its episode. The id alone does
  // not identify the episode, because a sequencer may give all episodes the same.
  const bool over = message.episode_id == last_episode_ && ToNanoseconds(message.header.stamp) < last_end_;
  if (!classifier_ || over) return;
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
    const core::Classification result = classifier_->Classify(episode, &feature_memory_);
    diagnosis_publisher_.publish(DiagnosisMessage(episode, model, result.diagnosis, final));
    if (!final) return;
    std_msgs::String event;
    event.data = result.diagnosis.event;
    event_publisher_.publish(event);
    features_publisher_.publish(FeaturesMessage(episode, model, result.features));
    ++diagnosed_;
    const std::string far = model.preparation.FarFrom(episode, model.sample_period);
    if (!far.empty()) {
      ++far_;
      ROS_WARN_THROTTLE(10.0, "Episode %s is far from all that the model was trained on: %s", episode.id.c_str(),
                        far.c_str());
    }
    episode_fault_.clear();
    WatchForChange(episode, result.diagnosis);
  } catch (const std::exception& error) {
    ++refused_;
    episode_fault_ = "episode " + message.episode_id + " is not diagnosed: " + OneLine(error.what());
    ROS_ERROR_THROTTLE(1.0, "%s", episode_fault_.c_str());
  }
}

bool ClassifierNode::OnNameCluster(NameCluster::Request& request, NameCluster::Response& response) {
  try {
    if (!classifier_) throw std::runtime_error("there is no model");
    classifier_->NameCluster(request.cluster, request.label);
    const std::string named = "cluster " + std::to_string(request.cluster) + " is " + request.label;
    try {
      response.message = named + ", " + SaveName(request.cluster, request.label);
      response.success = 1U;
    } catch (const std::exception& error) {
      throw std::runtime_error(named + " until this node ends, not saved: " + error.what());
    }
  } catch (const std::exception& error) {
    response.message = OneLine(error.what());
    ROS_ERROR("%s", response.message.c_str());
  }
  return true;
}

std::string ClassifierNode::SaveName(int cluster, const std::string& label) {
  if (options_.model.empty()) return "not saved: the model came from the topic; set ~model to its file to save names";
  const std::string& id = classifier_->model().id;
  // A training may have replaced the model. The name does not fit another one.
  const std::string in_file = LoadModel(options_.model).id;
  if (in_file != id) return "not saved: " + options_.model + " holds another model, " + in_file;
  const core::Model saved = NameClustersInFile(options_.model, id, {{cluster, label}});
  // Other processes may have named clusters in the file too.
  for (std::size_t index = 0; index < saved.clusters.size(); ++index) {
    const std::string& name = saved.clusters[index].label;
    if (!name.empty()) classifier_->NameCluster(static_cast<int>(index), name);
  }
  return "saved in " + options_.model;
}

void ClassifierNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!parameter_faults_.empty()) {
    status.summary(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
  } else if (!classifier_) {
    status.summary(DiagnosticStatus::ERROR, model_fault_.empty() ? "no model yet" : model_fault_);
  } else if (!model_fault_.empty() || !episode_fault_.empty()) {
    status.summary(DiagnosticStatus::WARN, model_fault_.empty() ? episode_fault_ : model_fault_);
  } else if (monitor_ && monitor_->change()) {
    status.summary(DiagnosticStatus::WARN, ChangeText(*monitor_->change()));
  } else {
    status.summary(DiagnosticStatus::OK, "model in use");
  }
  if (classifier_) {
    status.add("model", classifier_->model().id);
    status.add("trained at [s]", classifier_->model().provenance.trained / 1'000'000'000);
    status.add("shapelets", classifier_->model().shapelets.size());
    status.add("clusters", classifier_->model().clusters.size());
  }
  status.add("episodes diagnosed", diagnosed_);
  status.add("episodes refused", refused_);
  status.add("episodes far from the training", far_);
}

}  // namespace contact_shapelets
