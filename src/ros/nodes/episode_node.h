#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "contact_shapelets/core/wrench_stream.h"
#include "ros/messages/arrival_clock.h"
#include "ros/messages/publisher_watch.h"
#include "ros/nodes/kept_tare.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets {

/// Cuts the live wrench into episodes: topics, services and diagnostics around core::WrenchStream. Run() calls all
/// callbacks in one thread, because they share state without a lock.
class EpisodeNode {
 public:
  /// Reads parameters from `private_node_handle`, then sets up publishers, subscribers, services and timers. Logs
  /// parameters that are out of range and reports them in /diagnostics. The node then stays up, but cuts no episodes.
  EpisodeNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

  /// Serves the global queue and the wrench until the node shuts down. Takes wrenches every few milliseconds, and
  /// before each edge.
  void Run();

 private:
  void ReadParameters();
  void Advertise();
  void Subscribe();

  core::Nanoseconds NowOr(core::Nanoseconds otherwise) const;
  core::Nanoseconds ArrivalOf(const ros::Time& receipt, core::Nanoseconds otherwise) const;
  void TakeWrenches();
  /// An edge gets its place once a wrench follows it: waits for that one, but no longer than for a batch.
  void AwaitWrench();
  void OnWrench(const ros::MessageEvent<geometry_msgs::WrenchStamped const>& event);
  void OnActive(const ros::MessageEvent<std_msgs::Bool const>& event);
  void OnEvent(const ros::MessageEvent<EpisodeEvent const>& event);
  void OnStatus(const ros::MessageEvent<actionlib_msgs::GoalStatusArray const>& event);
  bool OnStart(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnStop(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnTare(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnCommand(bool open, std_srvs::Trigger::Response* response);

  void UseTare(const KeptTare& tare);
  void LetTimePass();
  void PublishNews();
  void PublishProgress();
  std::string WhatIsMissing(double duration, double idle);
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  EpisodeOptions options_;
  std::string parameter_faults_;
  std::unique_ptr<core::WrenchStream> stream_;  ///< null if parameters are out of range
  std::string frame_id_;
  bool is_tared_ = false;
  bool has_edge_ = false;
  PublisherWatch publisher_;
  ArrivalClock clock_;
  int published_episodes_ = 0;
  int idle_batches_ = 0;  ///< consecutive batches without a wrench, until time passes without one
  ros::SteadyTime last_wrench_ = ros::SteadyTime::now();
  core::Nanoseconds last_arrival_ = 0;
  std::deque<core::StreamSummary> laps_;  ///< one for each interval between diagnostics

  ros::CallbackQueue wrench_queue_;
  ros::Publisher episode_publisher_;
  ros::Publisher progress_publisher_;
  ros::Publisher event_publisher_;
  ros::Publisher tare_publisher_;
  ros::Subscriber wrench_subscriber_;
  ros::Subscriber active_subscriber_;
  ros::Subscriber event_subscriber_;
  ros::Subscriber status_subscriber_;
  ros::ServiceServer start_service_;
  ros::ServiceServer stop_service_;
  ros::ServiceServer tare_service_;
  ros::WallTimer progress_timer_;
  ros::WallTimer diagnostic_timer_;
  diagnostic_updater::Updater updater_;
};

}  // namespace contact_shapelets
