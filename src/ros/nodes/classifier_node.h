#pragma once

#include <contact_shapelets/Episode.h>
#include <contact_shapelets/NameCluster.h>
#include <contact_shapelets/ShapeletModel.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>

#include "contact_shapelets/core/classifier.h"
#include "core/drift/run_monitor.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {

/// Diagnoses the episodes of one robot by a model from a file or a topic. Only one thread may serve its callbacks,
/// because they share state without a lock.
class ClassifierNode {
 public:
  /// Reads parameters from `private_node_handle` and loads the model. Logs faults and reports them in /diagnostics. The
  /// node then stays up and takes a model from the topic.
  ClassifierNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

 private:
  void ReadParameters();
  void LoadModelFile();
  void Use(core::Model model);
  void WatchForChange(const core::Episode& episode, const core::Diagnosis& diagnosis);
  void OnModel(const ShapeletModel& message);
  void TakeNames(const ShapeletModel& message);
  void OnEpisode(const Episode& message);
  void OnProgress(const Episode& message);
  void Diagnose(const Episode& message, bool final);
  bool OnNameCluster(NameCluster::Request& request, NameCluster::Response& response);
  std::string SaveName(int cluster, const std::string& label);
  void Report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  ClassifierOptions options_;
  core::FeatureMemory feature_memory_;
  std::unique_ptr<core::Classifier> classifier_;  ///< null until there is a model
  std::optional<core::RunMonitor> monitor_;       ///< of the episodes since the model came into use
  std::string last_episode_;                      ///< id of the last episode that ended
  core::Nanoseconds last_end_ = 0;                ///< when that episode ended
  std::string parameter_faults_;
  bool model_is_relative_ = false;  ///< as the user gave it
  std::string model_fault_;         ///< why there is no model, or why the node refused the last one
  std::string episode_fault_;       ///< why the node refused the last episode; empty if it did not
  int diagnosed_ = 0;
  int refused_ = 0;
  int far_ = 0;  ///< number of diagnosed episodes that are far from all of the training

  ros::Publisher features_publisher_;
  ros::Publisher diagnosis_publisher_;
  ros::Publisher event_publisher_;
  ros::Subscriber episode_subscriber_;
  ros::Subscriber progress_subscriber_;
  ros::Subscriber model_subscriber_;
  ros::ServiceServer name_service_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
};

}  // namespace contact_shapelets
