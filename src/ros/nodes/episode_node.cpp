#include "ros/nodes/episode_node.h"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "ros/messages/action_edges.h"
#include "ros/messages/conversions.h"
#include "ros/messages/text.h"
#include "ros/messages/topics.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// A jump back of time by less is jitter.
constexpr core::Nanoseconds kJumpBack = 500'000'000;
/// [s] Wrenches are taken in batches: a thread that wakes for each of them costs more than all else here.
constexpr double kBatch = 0.004;
/// Batches without a wrench after which none is taken to come: fewer may be a busy machine's backlog.
constexpr int kIdleBatches = 8;
/// Diagnostics judge what happened within as many seconds: a fault that is over does not stay in them for ever.
constexpr std::size_t kRecent = 10;

core::Nanoseconds Now() { return ToNanoseconds(ros::Time::now()); }

/// Simulated time is 0 until its first message, which may arrive after the first wrenches and edges.
core::Nanoseconds NowOr(core::Nanoseconds otherwise) {
  const core::Nanoseconds now = Now();
  return now > 0 ? now : otherwise;
}

}  // namespace

EpisodeNode::EpisodeNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle), private_node_handle_(private_node_handle) {
  ReadParameters();
  Advertise();
  if (stream_) Subscribe();
  updater_.setHardwareID("none");
  updater_.add("wrench stream", this, &EpisodeNode::Diagnose);
  diagnostic_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0),
                                                   [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void EpisodeNode::ReadParameters() {
  ParameterReader reader(private_node_handle_);
  options_ = ReadEpisodeOptions(&reader);
  LogParameters(reader);
  parameter_faults_ = OneLine(reader.Faults());
  if (parameter_faults_.empty()) {
    stream_ = std::make_unique<core::WrenchStream>(options_.segmentation);
  } else {
    ROS_ERROR("No episode is cut until these parameters are mended and the node is started again: %s",
              parameter_faults_.c_str());
  }
}

void EpisodeNode::Advertise() {
  episode_publisher_ = node_handle_.advertise<Episode>(topics::kEpisode, topics::kResultQueue);
  progress_publisher_ = node_handle_.advertise<Episode>(topics::kEpisodeProgress, topics::kProgressQueue);
  event_publisher_ = node_handle_.advertise<EpisodeEvent>(topics::kEpisodeEvent, topics::kEdgeQueue);
  start_service_ = private_node_handle_.advertiseService("start", &EpisodeNode::OnStart, this);
  stop_service_ = private_node_handle_.advertiseService("stop", &EpisodeNode::OnStop, this);
  tare_service_ = private_node_handle_.advertiseService("tare", &EpisodeNode::OnTare, this);
}

void EpisodeNode::Subscribe() {
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  ros::NodeHandle wrench_node_handle(node_handle_);
  wrench_node_handle.setCallbackQueue(&wrench_queue_);
  wrench_subscriber_ =
      wrench_node_handle.subscribe(topics::kWrench, topics::kWrenchQueue, &EpisodeNode::OnWrench, this, no_delay);
  if (options_.segmentation.segmentation == core::Segmentation::kTrigger) {
    active_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeActive, topics::kEdgeQueue, &EpisodeNode::OnActive, this, no_delay);
    event_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeEvent, topics::kEdgeQueue, &EpisodeNode::OnEvent, this, no_delay);
  }
  if (options_.segmentation.segmentation == core::Segmentation::kAction) {
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
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kBatch));
    if (!stream_) continue;
    idle_batches_ = std::min(idle_batches_ + 1, kIdleBatches);
    TakeWrenches();
    if (idle_batches_ == kIdleBatches) LetTimePass();
  }
}

void EpisodeNode::TakeWrenches() { wrench_queue_.callAvailable(); }

void EpisodeNode::OnWrench(const ros::MessageEvent<geometry_msgs::WrenchStamped const>& event) {
  const geometry_msgs::WrenchStamped& wrench = *event.getConstMessage();
  if (frame_id_ != wrench.header.frame_id) {
    frame_id_ = wrench.header.frame_id;
    stream_->set_frame_id(frame_id_);
  }
  const core::Nanoseconds stamp = ToNanoseconds(wrench.header.stamp);
  // Not the time of now: all wrenches of a batch would have the same.
  const core::Nanoseconds receipt = ToNanoseconds(event.getReceiptTime());
  const core::Nanoseconds arrival = receipt > 0 ? receipt : NowOr(stamp);
  if (!stream_->AddWrench(stamp, arrival, ToVector(wrench.wrench.force))) {
    ROS_WARN_THROTTLE(
        10.0, "Wrenches that are not finite, above 1e6 N or out of order are dropped; /diagnostics counts them");
  }
  idle_batches_ = 0;
  last_wrench_ = ros::SteadyTime::now();
  last_arrival_ = arrival;
  if (!early_edges_.empty()) AddEarlyEdges();
  PublishNews();
}

void EpisodeNode::AddEdge(const std::function<void(core::Nanoseconds)>& add) {
  TakeWrenches();
  const core::Nanoseconds arrival = NowOr(last_arrival_);
  if (arrival < last_arrival_ - kJumpBack) {
    jumps_back_ = stream_->Summary().jumps_back;
    early_edges_.emplace_back([add, arrival] { add(arrival); });
    return;
  }
  early_edges_.clear();
  add(arrival);
  PublishNews();
}

void EpisodeNode::AddEarlyEdges() {
  if (stream_->Summary().jumps_back == jumps_back_) return;
  for (const std::function<void()>& add : early_edges_) add();
  early_edges_.clear();
}

void EpisodeNode::LetTimePass() {
  stream_->AdvanceTo(NowOr(last_arrival_));
  PublishNews();
}

void EpisodeNode::OnActive(const std_msgs::Bool& active) {
  AddEdge([this, open = active.data != 0](core::Nanoseconds arrival) { stream_->AddPlainEdge(open, arrival); });
}

void EpisodeNode::OnEvent(const ros::MessageEvent<EpisodeEvent const>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  AddEdge([this, message = event.getConstMessage()](core::Nanoseconds arrival) {
    stream_->AddStampedEdge(message->kind == EpisodeEvent::OPEN, ToNanoseconds(message->header.stamp),
                            message->episode_id, arrival);
  });
}

void EpisodeNode::OnStatus(const actionlib_msgs::GoalStatusArray& status) {
  const bool active = AnyGoalActive(status);
  if (active == action_active_) return;
  action_active_ = active;
  AddEdge([this, active, status](core::Nanoseconds arrival) {
    stream_->AddPlainEdge(active, TimeOfStatus(status, arrival));
  });
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
    AddEdge([this, open](core::Nanoseconds arrival) { stream_->AddCommand(open, arrival); });
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

void EpisodeNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!stream_) {
    status.summary(DiagnosticStatus::ERROR, "parameters are out of range: " + parameter_faults_);
    return;
  }
  laps_.push_back(stream_->TakeLap());
  if (laps_.size() > kRecent) laps_.pop_front();
  const core::StreamSummary recent = std::accumulate(laps_.begin(), laps_.end(), core::StreamSummary(), core::Joined);
  const core::StreamSummary summary = stream_->Summary();
  const std::vector<core::Finding> findings = core::FindingsOf(recent);
  const double idle = (ros::SteadyTime::now() - last_wrench_).toSec();
  if (summary.samples == 0) {
    status.summary(DiagnosticStatus::WARN, "no usable wrench yet on " + wrench_subscriber_.getTopic());
  } else if (idle > options_.segmentation.stream_timeout) {
    status.summaryf(DiagnosticStatus::ERROR, "no wrench for %.1f s", idle);
  } else if (findings.empty()) {
    status.summary(DiagnosticStatus::OK, "wrench arrives");
  } else {
    const bool error = findings.front().severity == core::Severity::kError;
    status.summary(error ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN, findings.front().text);
  }
  for (std::size_t index = 0; index < findings.size(); ++index) {
    status.add("finding " + std::to_string(index), findings[index].text);
  }
  status.add("rate [Hz]", recent.rate);
  status.add("jitter [s]", recent.jitter);
  status.add("longest interval [s]", recent.longest_interval);
  status.add("clock offset [s]", summary.clock_offset);
  status.add("samples", summary.samples);
  status.add("not finite", summary.not_finite);
  status.add("out of order", summary.out_of_order);
  status.add("repeated", summary.repeated);
  status.add("episodes", published_episodes_);
  status.add("dropped episodes", stream_->dropped_episodes());
}

}  // namespace contact_shapelets
