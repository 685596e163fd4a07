#pragma once

#include <actionlib/server/simple_action_server.h>
#include <contact_shapelets/TrainAction.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <mutex>
#include <string>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "contact_shapelets/ros/episode_bag_reader.h"

namespace contact_shapelets {

/// Trains models on recorded bags, by an action or once at the start. Publishes the newest model.
class TrainerNode {
 public:
  /// Reads parameters from `private_node_handle` and publishes the model in the file ~model. Logs faults and reports
  /// them in /diagnostics. If parameters are out of range, the node stays up and refuses goals.
  TrainerNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

  /// Trains once if ~bags and ~output are set. Returns when the training ends or ROS shuts down.
  void TrainAtStart();

 private:
  using Server = actionlib::SimpleActionServer<TrainAction>;

  /// One training.
  struct Task {
    std::vector<std::string> bags;
    std::string output;
    int clusters = 0;
  };

  void ReadParameters();
  void PublishModelFile(const std::string& path);
  void OnGoal(const TrainGoalConstPtr& goal);
  TrainResult Train(const Task& task, const core::ProgressCallback& progress);
  void TrainAndSave(const Task& task, const core::ProgressCallback& progress, TrainResult* result);
  int Threads() const;
  void SetState(int level, const std::string& text);
  void Report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  core::TrainerOptions options_;
  BagReaderOptions reader_options_;
  std::vector<std::string> start_bags_;
  std::string start_output_;
  std::string parameter_faults_;

  std::mutex training_mutex_;  ///< one training at a time
  std::mutex state_mutex_;     ///< guards the state: goals run in the action server's own thread
  int state_level_ = 0;
  std::string state_text_ = "idle";

  ros::Publisher model_publisher_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
  Server server_;
};

}  // namespace contact_shapelets
