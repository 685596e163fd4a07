#include "contact_shapelets/ros/episode_node.h"

#include <sstream>

#include "contact_shapelets/ros/action_edges.h"
#include "contact_shapelets/ros/conversions.h"
#include "contact_shapelets/ros/parameters.h"
#include "contact_shapelets/ros/topics.h"

namespace contact_shapelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;

core::Nanoseconds Now() { return ToNanoseconds(ros::Time::now()); }

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
  options_ = ReadSegmentationOptions(&reader);
  reader.Read("progress_rate", &progress_rate_);
  if (progress_rate_ < 0.0 || progress_rate_ > 100.0) {
    reader.AddFaults("progress_rate must be in [0, 100] Hz, but is " + std::to_string(progress_rate_) + "\n");
  }
  for (const std::string& name : reader.Unread()) ROS_WARN("~%s is not a parameter of this node", name.c_str());
  parameter_faults_ = reader.Faults();
  if (parameter_faults_.empty()) {
    stream_ = std::make_unique<core::WrenchStream>(options_);
  } else {
    ROS_ERROR("Episodes are not cut until these parameters are mended and the node is started again:\n%s",
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
  wrench_subscriber_ =
      node_handle_.subscribe(topics::kWrench, topics::kWrenchQueue, &EpisodeNode::OnWrench, this, no_delay);
  if (options_.segmentation == core::Segmentation::kTrigger) {
    active_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeActive, topics::kEdgeQueue, &EpisodeNode::OnActive, this, no_delay);
    event_subscriber_ =
        node_handle_.subscribe(topics::kEpisodeEvent, topics::kEdgeQueue, &EpisodeNode::OnEvent, this, no_delay);
  }
  if (options_.segmentation == core::Segmentation::kAction) {
    status_subscriber_ =
        node_handle_.subscribe(topics::kActionStatus, topics::kEdgeQueue, &EpisodeNode::OnStatus, this, no_delay);
  }
  // Only for waits that run out while no wrench arrives; whatever a wrench decides is published with it.
  wait_timer_ = node_handle_.createWallTimer(ros::WallDuration(0.01), [this](const ros::WallTimerEvent&) {
    stream_->AdvanceTo(Now());
    PublishNews();
  });
  if (progress_rate_ > 0.0) {
    progress_timer_ = node_handle_.createWallTimer(ros::WallDuration(1.0 / progress_rate_),
                                                   [this](const ros::WallTimerEvent&) { PublishProgress(); });
  }
}

void EpisodeNode::OnWrench(const geometry_msgs::WrenchStamped& wrench) {
  if (frame_id_ != wrench.header.frame_id) {
    frame_id_ = wrench.header.frame_id;
    stream_->segmenter().set_frame_id(frame_id_);
  }
  if (!stream_->AddWrench(ToNanoseconds(wrench.header.stamp), Now(), ToVector(wrench.wrench.force))) {
    ROS_WARN_THROTTLE(10.0, "Wrenches that are not finite or out of order are dropped; /diagnostics counts them");
  }
  PublishNews();
}

void EpisodeNode::OnActive(const std_msgs::Bool& active) {
  stream_->AddPlainEdge(active.data != 0, Now());
  PublishNews();
}

void EpisodeNode::OnEvent(const ros::MessageEvent<EpisodeEvent const>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  const EpisodeEvent& message = *event.getConstMessage();
  stream_->AddStampedEdge(message.kind == EpisodeEvent::OPEN, ToNanoseconds(message.header.stamp), message.episode_id,
                          Now());
  PublishNews();
}

void EpisodeNode::OnStatus(const actionlib_msgs::GoalStatusArray& status) {
  const bool active = AnyGoalActive(status);
  if (active != action_active_) stream_->AddPlainEdge(active, TimeOfStatus(status, Now()));
  action_active_ = active;
  PublishNews();
}

bool EpisodeNode::OnStart(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  return OnCommand(true, &response);
}

bool EpisodeNode::OnStop(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  return OnCommand(false, &response);
}

bool EpisodeNode::OnCommand(bool open, std_srvs::Trigger::Response* response) {
  if (!stream_) {
    response->message = "parameters are out of range: " + parameter_faults_;
  } else if (stream_->segmenter().IsOpen() == open) {
    response->message = open ? "an episode is open already" : "no episode is open";
  } else {
    stream_->AddCommand(open, Now());
    PublishNews();
    response->success = 1U;
    response->message = open ? "episode opened" : "episode closed";
  }
  return true;
}

bool EpisodeNode::OnTare(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  try {
    if (!stream_) throw std::runtime_error("parameters are out of range: " + parameter_faults_);
    const Eigen::Vector3d offset = stream_->segmenter().TareNow();
    std::ostringstream text;
    text << "offset [N]: " << offset.x() << ' ' << offset.y() << ' ' << offset.z();
    if (options_.tare != core::TareSource::kService) text << " (not used: ~tare is not \"service\")";
    response.success = 1U;
    response.message = text.str();
  } catch (const std::runtime_error& error) {
    response.message = error.what();
  }
  return true;
}

void EpisodeNode::PublishNews() {
  if (!stream_->segmenter().HasNews()) return;
  for (const core::Episode& episode : stream_->segmenter().TakeEpisodes()) {
    episode_publisher_.publish(ToMessage(episode));
    ++published_episodes_;
  }
  for (const core::EpisodeEdge& edge : stream_->segmenter().TakeEdges()) {
    event_publisher_.publish(ToMessage(edge, frame_id_));
  }
}

void EpisodeNode::PublishProgress() {
  if (progress_publisher_.getNumSubscribers() == 0) return;
  if (const auto episode = stream_->segmenter().OpenEpisode()) progress_publisher_.publish(ToMessage(*episode));
}

void EpisodeNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!stream_) {
    status.summary(DiagnosticStatus::ERROR, "parameters are out of range");
    status.add("faults", parameter_faults_);
    return;
  }
  const core::StreamSummary summary = stream_->Summary();
  const std::vector<std::string> findings = core::Findings(summary);
  if (summary.samples == 0) {
    status.summary(DiagnosticStatus::WARN, "no wrench yet on " + wrench_subscriber_.getTopic());
  } else if (findings.empty()) {
    status.summary(DiagnosticStatus::OK, "wrench arrives");
  } else {
    const bool frozen = findings.front().rfind("frozen", 0) == 0;
    status.summary(frozen ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN, findings.front());
  }
  for (std::size_t index = 0; index < findings.size(); ++index) status.add("finding " + std::to_string(index), findings[index]);
  status.add("rate [Hz]", summary.rate);
  status.add("jitter [s]", summary.jitter);
  status.add("longest interval [s]", summary.longest_interval);
  status.add("clock offset [s]", summary.clock_offset);
  status.add("samples", summary.samples);
  status.add("not finite", summary.not_finite);
  status.add("out of order", summary.out_of_order);
  status.add("repeated", summary.repeated);
  status.add("episodes", published_episodes_);
  status.add("dropped episodes", stream_->segmenter().dropped_episodes());
}

}  // namespace contact_shapelets
