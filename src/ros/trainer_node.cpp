#include "contact_shapelets/ros/trainer_node.h"

#include <limits>
#include <map>
#include <stdexcept>

#include "contact_shapelets/core/partition_metrics.h"
#include "contact_shapelets/ros/conversions.h"
#include "contact_shapelets/ros/model_bag.h"
#include "contact_shapelets/ros/parameters.h"
#include "contact_shapelets/ros/topics.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Rand index of the clusters against the outcomes that are given; NaN where fewer than two are.
float RandIndexOf(const std::vector<core::Episode>& episodes, const Eigen::Ref<const Eigen::VectorXi>& labels) {
  std::map<std::string, int> classes;
  std::vector<int> used;
  std::vector<int> given;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    if (episodes[index].outcome.empty()) continue;
    used.push_back(labels[static_cast<Eigen::Index>(index)]);
    given.push_back(classes.emplace(episodes[index].outcome, static_cast<int>(classes.size())).first->second);
  }
  if (used.size() < 2) return std::numeric_limits<float>::quiet_NaN();
  const auto size = static_cast<Eigen::Index>(used.size());
  return static_cast<float>(core::ComparePartitions(Eigen::Map<const Eigen::VectorXi>(used.data(), size),
                                                    Eigen::Map<const Eigen::VectorXi>(given.data(), size))
                                .rand_index);
}

}  // namespace

TrainerNode::TrainerNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle),
      private_node_handle_(private_node_handle),
      server_(node_handle_, "train", [this](const TrainGoalConstPtr& goal) { OnGoal(goal); }, false) {
  model_publisher_ = node_handle_.advertise<ShapeletModel>(topics::kModel, 1, true);
  ReadParameters();
  updater_.setHardwareID("none");
  updater_.add("training", this, &TrainerNode::Report);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  server_.start();
}

void TrainerNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  options_ = ReadTrainerOptions(&reader);
  reader_options_.segmentation = ReadSegmentationOptions(&reader);
  std::string model;
  reader.Read("wrench_topic", &reader_options_.wrench_topic);
  reader.Read("model", &model);
  reader.Read("bags", &start_bags_);
  reader.Read("output", &start_output_);
  for (const std::string& name : reader.Unread()) ROS_WARN("~%s is not a parameter of this node", name.c_str());
  parameter_faults_ = reader.Faults();
  if (!parameter_faults_.empty()) {
    ROS_ERROR("Nothing is trained until these parameters are mended and the node is started again:\n%s",
              parameter_faults_.c_str());
    SetState(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
  }
  if (model.empty()) return;
  try {
    model_publisher_.publish(ToMessage(LoadModel(model), ros::Time::now()));
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
    SetState(DiagnosticStatus::ERROR, error.what());
  }
}

bool TrainerNode::TrainAtStart() {
  if (start_bags_.empty() || start_output_.empty()) return true;
  const TrainResult result = Train(start_bags_, start_output_, 0, [](const core::TrainingProgress& progress) {
    ROS_INFO_THROTTLE(2.0, "Training: %.0f %%", 100.0 * progress.fraction_done);
    return ros::ok();
  });
  return result.success != 0U;
}

void TrainerNode::OnGoal(const TrainGoalConstPtr& goal) {
  const TrainResult result =
      Train(goal->bags, goal->output, static_cast<int>(goal->clusters), [this](const core::TrainingProgress& progress) {
        TrainFeedback feedback;
        feedback.candidate = static_cast<std::uint32_t>(progress.candidate);
        feedback.step = static_cast<std::uint32_t>(progress.step);
        feedback.objective = static_cast<float>(progress.objective);
        feedback.fraction_done = static_cast<float>(progress.fraction_done);
        server_.publishFeedback(feedback);
        return !server_.isPreemptRequested() && ros::ok();
      });
  if (result.success != 0U) {
    server_.setSucceeded(result, result.message);
  } else if (server_.isPreemptRequested()) {
    server_.setPreempted(result, result.message);
  } else {
    server_.setAborted(result, result.message);
  }
}

TrainResult TrainerNode::Train(const std::vector<std::string>& bags, const std::string& output, int clusters,
                               const core::ProgressCallback& progress) {
  TrainResult result;
  result.rand_index = std::numeric_limits<float>::quiet_NaN();
  try {
    if (!parameter_faults_.empty()) throw std::runtime_error("parameters are out of range: " + parameter_faults_);
    if (output.empty()) throw std::runtime_error("output: expected the path of the model to write, but it is empty");
    SetState(DiagnosticStatus::OK, "training");
    core::TrainerOptions options = options_;
    if (clusters > 0) options.clusters = clusters;
    const std::vector<core::Episode> episodes = ReadAllEpisodes(bags, reader_options_);
    core::TrainingResult training = core::TrainModel(episodes, options, progress);
    training.model.provenance.sources = bags;
    SaveModel(output, training.model);
    model_publisher_.publish(ToMessage(training.model, ros::Time::now()));
    result.success = 1U;
    result.model_id = training.model.id;
    result.episodes = static_cast<std::uint32_t>(episodes.size());
    result.rand_index = RandIndexOf(episodes, training.labels);
    result.message = "trained on " + std::to_string(episodes.size()) + " episodes, saved in " + output;
    SetState(DiagnosticStatus::OK, result.message);
    ROS_INFO("%s", result.message.c_str());
  } catch (const core::TrainingCancelled& error) {
    result.message = error.what();
    SetState(DiagnosticStatus::OK, result.message);
  } catch (const std::exception& error) {
    result.message = error.what();
    SetState(DiagnosticStatus::ERROR, result.message);
    ROS_ERROR("%s", error.what());
  }
  return result;
}

void TrainerNode::SetState(int level, const std::string& text) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  state_level_ = level;
  state_text_ = text;
}

void TrainerNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  status.summary(static_cast<unsigned char>(state_level_), state_text_);
}

}  // namespace contact_shapelets
