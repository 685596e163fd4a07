#include "ros/nodes/trainer_node.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "contact_shapelets/ros/model_bag.h"
#include "core/numerics/parallel.h"
#include "evaluation/partition_metrics.h"
#include "ros/bags/output_file.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/text.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Part of the progress that reading takes: an estimate for bags of raw wrench.
constexpr double kReadingPart = 0.1;
/// Cores that a training leaves free for the driver, the episodes and the diagnoses.
constexpr int kSpareThreads = 1;

}  // namespace

TrainerNode::TrainerNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle),
      private_node_handle_(private_node_handle),
      server_(
          node_handle_, actions::kTrain, [this](const TrainGoalConstPtr& goal) { OnGoal(goal); }, false) {
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
  reader_options_.segmentation = ReadEpisodeOptions(&reader).segmentation;
  std::string model;
  reader.Read(parameters::kWrenchTopic, &reader_options_.wrench_topic);
  reader.Read(parameters::kModel, &model);
  reader.Read(parameters::kBags, &start_bags_);
  reader.Read(parameters::kOutput, &start_output_);
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (!parameter_faults_.empty()) {
    ROS_ERROR("This node trains no model. Correct these parameters and start it again: %s", parameter_faults_.c_str());
    SetState(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
  }
  if (!model.empty()) PublishModelFile(AbsolutePath(model));
}

void TrainerNode::PublishModelFile(const std::string& path) {
  try {
    model_publisher_.publish(ToMessage(LoadModel(path)));
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
    SetState(DiagnosticStatus::ERROR, OneLine(error.what()));
  }
}

void TrainerNode::TrainAtStart() {
  if (start_bags_.empty() && start_output_.empty()) return;
  Train({start_bags_, start_output_, options_.clusters}, [](const core::TrainingProgress& progress) {
    ROS_INFO_THROTTLE(2.0, "Training: %.0f %%", 100.0 * progress.fraction_done);
    return ros::ok();
  });
}

void TrainerNode::OnGoal(const TrainGoalConstPtr& goal) {
  const auto greatest = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  const int clusters = goal->clusters > 0 ? static_cast<int>(std::min(goal->clusters, greatest)) : options_.clusters;
  const TrainResult result =
      Train({goal->bags, goal->output, clusters}, [this](const core::TrainingProgress& progress) {
        TrainFeedback feedback;
        feedback.bank = static_cast<std::uint32_t>(progress.bank);
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

TrainResult TrainerNode::Train(const Task& task, const core::ProgressCallback& progress) {
  TrainResult result;
  result.rand_index = std::numeric_limits<float>::quiet_NaN();
  const std::unique_lock<std::mutex> training(training_mutex_, std::try_to_lock);
  if (!training.owns_lock()) {
    result.message = "another training is running";
    return result;
  }
  try {
    TrainAndSave(task, progress, &result);
    result.success = 1U;
    SetState(DiagnosticStatus::OK, result.message);
    ROS_INFO("%s", result.message.c_str());
  } catch (const core::Cancelled&) {
    result.message = "the training was cancelled";
    SetState(DiagnosticStatus::OK, result.message);
    ROS_INFO("%s", result.message.c_str());
  } catch (const std::exception& error) {
    result.message = OneLine(error.what());
    SetState(DiagnosticStatus::ERROR, result.message);
    ROS_ERROR("%s", result.message.c_str());
  }
  return result;
}

void TrainerNode::TrainAndSave(const Task& task, const core::ProgressCallback& progress, TrainResult* result) {
  if (!parameter_faults_.empty()) throw std::runtime_error("parameters are out of range: " + parameter_faults_);
  const auto go_on = [&progress](const core::TrainingProgress& state) {
    if (!progress(state)) throw core::Cancelled();
  };
  std::vector<std::string> bags;
  for (const std::string& bag : task.bags) bags.push_back(AbsolutePath(bag));
  const std::string output = AbsolutePath(task.output);
  CheckModelOutput("output", output, bags);
  SetState(DiagnosticStatus::OK, "training");
  core::Preparation preparation;
  const auto on_read = [&go_on](double done) { go_on({0, 0, 0.0, kReadingPart * done}); };
  std::vector<core::Episode> episodes = ReadAllEpisodes(bags, reader_options_, on_read, &preparation);

  const int incomplete = core::TakeIncomplete(options_, &episodes);
  result->incomplete = static_cast<std::uint32_t>(incomplete);

  core::TrainerOptions options = options_;
  options.clusters = task.clusters;
  options.threads = Threads();
  core::TrainingProgress last;
  core::TrainingResult training =
      core::TrainModel(episodes, options, [&progress, &last](const core::TrainingProgress& state) {
        last = state;
        last.fraction_done = kReadingPart + (1.0 - kReadingPart) * state.fraction_done;
        return progress(last);
      });
  go_on(last);
  training.model.provenance.sources = bags;
  training.model.provenance.trained = WallNow();
  preparation.SetRanges(episodes);
  training.model.preparation = preparation;
  SaveModel(output, training.model);
  model_publisher_.publish(ToMessage(training.model));
  result->model_id = training.model.id;
  result->episodes = static_cast<std::uint32_t>(episodes.size());
  const auto agreement = evaluation::CompareWithOutcomes(training.labels, episodes);
  if (agreement) result->rand_index = static_cast<float>(agreement->scores.rand_index);
  result->message = "trained on " + std::to_string(episodes.size()) + " episodes, " +
                    (incomplete > 0 ? std::to_string(incomplete) + " incomplete ones left out, " : "") + "saved in " +
                    output;
}

int TrainerNode::Threads() const { return core::ThreadCount(options_.threads, kSpareThreads); }

void TrainerNode::SetState(int level, const std::string& text) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  state_level_ = level;
  state_text_ = text;
}

void TrainerNode::Report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  status.summary(static_cast<unsigned char>(state_level_), state_text_);
  status.add("threads", Threads());
}

}  // namespace contact_shapelets
