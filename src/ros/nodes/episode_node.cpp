#include "ros/nodes/episode_node.h"

#include <ros/master.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "contact_shapelets/ros/model_bag.h"
#include "ros/messages/action_edges.h"
#include "ros/messages/conversions.h"
#include "ros/messages/missing_input.h"
#include "ros/messages/names.h"
#include "ros/messages/text.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// [s] Time between batches of wrenches. A thread that wakes for each wrench would cost more than all other work here.
constexpr double kBatch = 0.004;
/// After this many batches without a wrench the stream counts as silent. Fewer may be the backlog of a busy machine.
constexpr int kIdleBatches = 8;
/// [s] Diagnostics report the findings of this time, so that an old one does not stay for ever.
constexpr std::size_t kRecent = 10;

ClockReading ReadClocks() {
  const std::uint64_t steady = ros::SteadyTime::now().toNSec();
  return {ToNanoseconds(ros::Time::now()), static_cast<core::Nanoseconds>(steady)};
}

/// Returns how the training episodes of the model file `path` were cut; the defaults if that is not known.
core::SegmentationOptions SegmentationOf(const std::string& path) {
  if (path.empty()) return {};
  try {
    const auto segmentation = LoadModel(AbsolutePath(path)).preparation.segmentation;
    if (segmentation) {
      ROS_INFO("Cutting episodes as for the model %s: segmentation %s, tare %s", path.c_str(),
               core::NameOf(segmentation->segmentation).c_str(), core::NameOf(segmentation->tare).c_str());
      return *segmentation;
    }
    ROS_INFO("%s does not say how its episodes were cut; the defaults count", path.c_str());
  } catch (const std::exception& error) {
    ROS_WARN("The defaults say how to cut episodes, because the model cannot be read: %s", error.what());
  }
  return {};
}

/// Returns the topics of the wrench's type that nodes publish.
std::vector<std::string> WrenchTopics() {
  ros::master::V_TopicInfo all;
  ros::master::getTopics(all);
  std::vector<std::string> topics;
  for (const ros::master::TopicInfo& topic : all) {
    if (topic.datatype == ros::message_traits::datatype<geometry_msgs::WrenchStamped>()) topics.push_back(topic.name);
  }
  return topics;
}

}  // namespace

EpisodeNode::EpisodeNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ReadParameters();
  Advertise();
  if (const auto tare = FindKeptTare(private_node_handle_); tare && stream_) UseTare(*tare);
  if (stream_) Subscribe();
  updater_.setHardwareID("none");
  updater_.add("wrench stream", this, &EpisodeNode::Diagnose);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void EpisodeNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  std::string model;
  reader.Read(parameters::kPreparation, &model);
  options_ = ReadEpisodeOptions(&reader, SegmentationOf(model));
  reader.Skip(kTareParameter);
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (parameter_faults_.empty()) {
    stream_ = std::make_unique<core::WrenchStream>(options_.segmentation);
  } else {
    ROS_ERROR("This node cuts no episodes. Correct these parameters and start it again: %s", parameter_faults_.c_str());
  }
}

void EpisodeNode::Advertise() {
  episode_publisher_ = node_handle_.advertise<Episode>(topics::kEpisode, topics::kResultQueue);
  progress_publisher_ = node_handle_.advertise<Episode>(topics::kEpisodeProgress, topics::kProgressQueue);
  event_publisher_ = node_handle_.advertise<EpisodeEvent>(topics::kEpisodeEvent, topics::kEdgeQueue);
  tare_publisher_ = node_handle_.advertise<Tare>(topics::kTare, 1, true);
  start_service_ = private_node_handle_.advertiseService(services::kStart, &EpisodeNode::OnStart, this);
  stop_service_ = private_node_handle_.advertiseService(services::kStop, &EpisodeNode::OnStop, this);
  tare_service_ = private_node_handle_.advertiseService(services::kTare, &EpisodeNode::OnTare, this);
}

void EpisodeNode::Subscribe() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  ros::NodeHandle wrench_node_handle(node_handle_);
  wrench_node_handle.setCallbackQueue(&wrench_queue_);
  wrench_subscriber_ =
      wrench_node_handle.subscribe(topics::kWrench, topics::kWrenchQueue, &EpisodeNode::OnWrench, this, no_delay);
  if (options_.segmentation.segmentation == core::SegmentationMode::kTrigger) {
    active_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeActive, topics::kEdgeQueue, &EpisodeNode::OnActive, this, no_delay);
    event_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeEvent, topics::kEdgeQueue, &EpisodeNode::OnEvent, this, no_delay);
  }
  if (options_.segmentation.segmentation == core::SegmentationMode::kAction) {
    status_subscriber_ =
        node_handle_.subscribe(topics::kActionStatus, topics::kEdgeQueue, &EpisodeNode::OnStatus, this, no_delay);
  }
  if (options_.progress_rate > 0.0) {
    progress_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0 / options_.progress_rate),
                                                   [this](const ros::WallTimerEvent&) { PublishProgress(); });
  }
}

void EpisodeNode::Run() {
  while (node_handle_.ok()) {
    clock_.Look(ReadClocks());
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kBatch));
    if (!stream_) continue;
    idle_batches_ = std::min(idle_batches_ + 1, kIdleBatches);
    TakeWrenches();
    if (idle_batches_ == kIdleBatches) LetTimePass();
  }
}

/// Simulated time counts as it is. It is 0 until its first message, which may come after the first wrenches and edges.
core::Nanoseconds EpisodeNode::NowOr(core::Nanoseconds otherwise) const {
  if (ros::Time::isSystemTime()) return clock_.Now(ReadClocks());
  const core::Nanoseconds now = ToNanoseconds(ros::Time::now());
  return now > 0 ? now : otherwise;
}

core::Nanoseconds EpisodeNode::ArrivalOf(const ros::Time& receipt, core::Nanoseconds otherwise) const {
  if (receipt.isZero()) return NowOr(otherwise);
  return ros::Time::isSystemTime() ? clock_.Of(ToNanoseconds(receipt), ReadClocks()) : ToNanoseconds(receipt);
}

void EpisodeNode::TakeWrenches() { wrench_queue_.callAvailable(); }

void EpisodeNode::AwaitWrench() { wrench_queue_.callAvailable(ros::WallDuration(kBatch)); }

void EpisodeNode::OnWrench(const ros::MessageEvent<geometry_msgs::WrenchStamped const>& event) {
  const geometry_msgs::WrenchStamped& wrench = *event.getConstMessage();
  if (frame_id_ != wrench.header.frame_id) {
    frame_id_ = wrench.header.frame_id;
    stream_->set_frame_id(frame_id_);
  }
  if (const auto publisher = publisher_.Next(event.getConnectionHeaderPtr())) stream_->SetPublisher(*publisher);
  const core::Nanoseconds stamp = ToNanoseconds(wrench.header.stamp);
  // All wrenches of a batch would have the same time if it were now.
  const core::Nanoseconds arrival = ArrivalOf(event.getReceiptTime(), stamp);
  if (!stream_->AddWrench(stamp, arrival, ToVector(wrench.wrench.force))) {
    ROS_WARN_THROTTLE(10.0,
                      "Dropping wrenches that are not finite, above 1e6 N or out of order; /diagnostics counts them");
  }
  idle_batches_ = 0;
  last_wrench_ = ros::SteadyTime::now();
  last_arrival_ = arrival;
  PublishNews();
}

void EpisodeNode::LetTimePass() {
  stream_->AdvanceTo(NowOr(last_arrival_));
  PublishNews();
}

void EpisodeNode::OnActive(const ros::MessageEvent<std_msgs::Bool const>& event) {
  has_edge_ = true;
  TakeWrenches();
  stream_->AddUnstampedEdge(event.getConstMessage()->data != 0, ArrivalOf(event.getReceiptTime(), last_arrival_));
  AwaitWrench();
  PublishNews();
}

void EpisodeNode::OnEvent(const ros::MessageEvent<EpisodeEvent const>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  has_edge_ = true;
  TakeWrenches();
  const EpisodeEvent& message = *event.getConstMessage();
  stream_->AddStampedEdge(message.kind == EpisodeEvent::OPEN, ToNanoseconds(message.header.stamp), message.episode_id,
                          ArrivalOf(event.getReceiptTime(), last_arrival_), event.getPublisherName());
  AwaitWrench();
  PublishNews();
}

void EpisodeNode::OnStatus(const ros::MessageEvent<actionlib_msgs::GoalStatusArray const>& event) {
  has_edge_ = true;
  TakeWrenches();
  stream_->AddStatus(AnyGoalActive(*event.getConstMessage()), ArrivalOf(event.getReceiptTime(), last_arrival_));
  PublishNews();
}

bool EpisodeNode::OnStart(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  return OnCommand(true, &response);
}

bool EpisodeNode::OnStop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  return OnCommand(false, &response);
}

bool EpisodeNode::OnCommand(bool open, std_srvs::Trigger::Response* response) {
  TakeWrenches();
  if (!stream_) {
    response->message = "parameters are out of range: " + parameter_faults_;
  } else if (stream_->IsOpen() == open) {
    response->message = open ? "an episode is open already" : "no episode is open";
  } else {
    has_edge_ = true;
    stream_->AddCommand(open, NowOr(last_arrival_));
    PublishNews();
    response->success = 1U;
    response->message = open ? "episode opened" : "episode closed";
  }
  return true;
}

bool EpisodeNode::OnTare(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  try {
    if (!stream_) throw std::runtime_error("parameters are out of range: " + parameter_faults_);
    TakeWrenches();
    const Eigen::Vector3d offset = stream_->TareNow();
    const KeptTare tare{offset, stream_->last_wrench()};
    KeepTare(private_node_handle_, tare);
    UseTare(tare);
    std::ostringstream text;
    text << "offset [N]: " << offset.x() << ' ' << offset.y() << ' ' << offset.z();
    if (options_.segmentation.tare != core::TareSource::kService) text << " (not used: ~tare is not \"service\")";
    response.success = 1U;
    response.message = text.str();
  } catch (const std::runtime_error& error) {
    response.message = error.what();
  }
  return true;
}

void EpisodeNode::UseTare(const KeptTare& tare) {
  is_tared_ = true;
  stream_->SetTare(tare.force);
  tare_publisher_.publish(TareMessage(tare.force, tare.stamp, frame_id_));
}

void EpisodeNode::PublishNews() {
  if (!stream_->HasNews()) return;
  for (const core::Episode& episode : stream_->TakeEpisodes()) {
    episode_publisher_.publish(ToMessage(episode));
    ++published_episodes_;
  }
  for (const core::EpisodeEdge& edge : stream_->TakeEdges()) {
    event_publisher_.publish(ToMessage(edge, frame_id_));
  }
}

void EpisodeNode::PublishProgress() {
  if (progress_publisher_.getNumSubscribers() == 0) return;
  if (const auto episode = stream_->OpenEpisode()) progress_publisher_.publish(ToMessage(*episode));
}

/// Warns once of a missing wrench, and once of a missing trigger. Returns the warning as long as that is missing.
std::string EpisodeNode::WhatIsMissing(double duration, double idle) {
  std::string triggers;
  if (active_subscriber_) triggers = active_subscriber_.getTopic() + " and " + event_subscriber_.getTopic();
  if (status_subscriber_) triggers = status_subscriber_.getTopic();
  const bool wrench = last_arrival_ != 0;
  const std::string missing =
      MissingInput({wrench, has_edge_, idle, duration, wrench_subscriber_.getTopic(), triggers}, WrenchTopics);
  if (missing.empty()) return missing;
  if (wrench) {
    ROS_WARN_ONCE("%s", missing.c_str());
  } else {
    ROS_WARN_ONCE("%s", missing.c_str());
  }
  return missing;
}

void EpisodeNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!stream_) {
    status.summary(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
    return;
  }
  laps_.push_back(stream_->TakeLap());
  if (laps_.size() > kRecent) laps_.pop_front();
  const core::StreamSummary recent = std::accumulate(laps_.begin(), laps_.end(), core::StreamSummary(), core::Joined);
  const core::StreamSummary summary = stream_->Summary();
  std::vector<core::Finding> findings = core::FindingsOf(recent);
  for (core::Finding& finding : core::EpisodeFindingsOf(recent)) findings.push_back(std::move(finding));
  const bool untared = options_.segmentation.tare == core::TareSource::kService && !is_tared_;
  if (untared) findings.push_back({core::Severity::kWarning, "not tared", "call ~tare in free air"});
  const double idle = (ros::SteadyTime::now() - last_wrench_).toSec();
  const std::string missing = WhatIsMissing(summary.duration, idle);
  if (!missing.empty()) findings.insert(findings.begin(), {core::Severity::kWarning, missing, ""});
  const auto error = std::find_if(findings.begin(), findings.end(), [](const core::Finding& finding) {
    return finding.severity == core::Severity::kError;
  });
  if (summary.samples == 0) {
    const std::string nothing = "no usable wrench yet on " + wrench_subscriber_.getTopic();
    status.summary(DiagnosticStatus::WARN, missing.empty() ? nothing : missing);
  } else if (idle > options_.segmentation.stream_timeout) {
    status.summaryf(DiagnosticStatus::ERROR, "no wrench for %.1f s", idle);
  } else if (findings.empty()) {
    status.summary(DiagnosticStatus::OK, "wrench arrives");
  } else if (error != findings.end()) {
    status.summary(DiagnosticStatus::ERROR, error->text);
  } else {
    status.summary(DiagnosticStatus::WARN, findings.front().text);
  }
  for (std::size_t index = 0; index < findings.size(); ++index) {
    status.add("finding " + std::to_string(index), findings[index].text);
  }
  status.add("rate [Hz]", recent.rate);
  status.add("jitter [s]", recent.jitter);
  status.add("longest interval [s]", recent.longest_interval);
  status.add("clock offset [s]", summary.clock_offset);
  status.add("clock drift [s/s]", summary.clock_drift);
  status.add("samples", summary.samples);
  status.add("not finite", summary.not_finite);
  status.add("out of order", summary.out_of_order);
  status.add("repeated", summary.repeated);
  status.add("episodes", published_episodes_);
  status.add("dropped episodes", core::DroppedEpisodes(summary));
}

}  // namespace contact_shapelets
