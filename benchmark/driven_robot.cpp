#include "driven_robot.h"

#include <contact_shapelets/EpisodeEvent.h>
#include <geometry_msgs/WrenchStamped.h>
#include <std_msgs/Bool.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "wait.h"

namespace contact_shapelets::benchmark {
namespace {

/// [s] A driver that restarts counts from here on.
constexpr double kAnew = 1000.0;
/// [s] that an unstamped edge may be off, without the jitter.
constexpr double kPlainTolerance = 0.005;
/// [s] around a push in which a fault touches it.
constexpr double kReach = 0.1;

std::int64_t ToNanoseconds(double seconds) { return std::llround(1e9 * seconds); }

ros::Time ToTime(std::int64_t stamp) { return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp)); }

std::int64_t StampOf(const std_msgs::Header& header) { return static_cast<std::int64_t>(header.stamp.toNSec()); }

}  // namespace

DrivenRobot::DrivenRobot(const std::string& name, double rate, bool stamped, const ClockFaults& faults)
    : name_(name),
      rate_(rate),
      stamped_(stamped),
      faults_(faults),
      start_(static_cast<std::int64_t>(ros::Time::now().toNSec())) {
  wrench_publisher_ = node_handle_.advertise<geometry_msgs::WrenchStamped>(name + "/wrench", 2000);
  edge_publisher_ = stamped ? node_handle_.advertise<EpisodeEvent>(name + "/episode_event", 10)
                            : node_handle_.advertise<std_msgs::Bool>(name + "/episode_active", 10);
  const ros::TransportHints no_delay = ros::TransportHints().tcpNoDelay();
  diagnosis_subscriber_ = node_handle_.subscribe<Diagnosis>(
      name + "/diagnosis", 100,
      [this](const Diagnosis::ConstPtr& diagnosis) {
        const ros::WallTime now = ros::WallTime::now();
        if (diagnosis->final == 0U) return;
        const std::lock_guard<std::mutex> lock(mutex_);
        diagnoses_.push_back({StampOf(diagnosis->header), now});
      },
      ros::VoidConstPtr(), no_delay);
  episode_subscriber_ = node_handle_.subscribe<Episode>(
      name + "/episode", 100,
      [this](const Episode::ConstPtr& episode) {
        const std::lock_guard<std::mutex> lock(mutex_);
        episodes_.push_back(*episode);
      },
      ros::VoidConstPtr(), no_delay);
}

bool DrivenRobot::WaitForConnections() const {
  return WaitUntil([this] {
    return wrench_publisher_.getNumSubscribers() > 0 && edge_publisher_.getNumSubscribers() > 0 &&
           diagnosis_subscriber_.getNumPublishers() > 0 && episode_subscriber_.getNumPublishers() > 0;
  });
}

std::int64_t DrivenRobot::Stamp(double now) const {
  const double restarted = now - faults_.restart_at;
  if (restarted >= 0.0) return ToNanoseconds(kAnew) + ToNanoseconds(restarted * (1.0 + faults_.drift));
  return start_ + ToNanoseconds(now * (1.0 + faults_.drift) + (now >= faults_.step_at ? faults_.step : 0.0));
}

void DrivenRobot::Send(double due, double now) {
  if (due >= faults_.restart_at && due < faults_.restart_at + faults_.pause) return;
  const auto period = static_cast<std::size_t>(0.6 * rate_);
  const std::size_t number = samples_.size();
  const std::size_t position = number % period;
  geometry_msgs::WrenchStamped wrench;
  const std::int64_t stamp = Stamp(now);
  wrench.header.stamp = ToTime(stamp);
  const double push = 10.0 * std::sin(0.02 * static_cast<double>(position));
  wrench.wrench.force.z = push + 0.01 * static_cast<double>(number % 7);
  const ros::WallTime sent = ros::WallTime::now();
  wrench_publisher_.publish(wrench);
  samples_.push_back({stamp, wrench.wrench.force.z, now, now - due});
  if (position == period / 6) {
    open_ = number;
    SendEdge(true, stamp);
  } else if (position == period - 1 && open_) {
    pushes_.push_back({*open_, number, sent});
    SendEdge(false, stamp);
  }
}

void DrivenRobot::SendEdge(bool open, std::int64_t stamp) {
  if (!stamped_) {
    std_msgs::Bool active;
    active.data = open ? 1U : 0U;
    edge_publisher_.publish(active);
    return;
  }
  EpisodeEvent event;
  event.header.stamp = ToTime(stamp);
  event.kind = open ? EpisodeEvent::OPEN : EpisodeEvent::CLOSE;
  event.episode_id = std::to_string(*open_);
  edge_publisher_.publish(event);
}

/// The push whose opening is nearest. The driver's clock never has one time twice.
std::size_t DrivenRobot::PushAt(std::int64_t stamp) const {
  std::size_t nearest = 0;
  const auto distance = [&](const Push& push) { return std::abs(samples_[push.open].stamp - stamp); };
  for (std::size_t index = 1; index < pushes_.size(); ++index) {
    if (distance(pushes_[index]) < distance(pushes_[nearest])) nearest = index;
  }
  return nearest;
}

bool DrivenRobot::HasLastEpisode() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return pushes_.empty() || (!episodes_.empty() && PushAt(StampOf(episodes_.back().header)) + 1 == pushes_.size());
}

std::vector<double> DrivenRobot::Latencies() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<double> latencies;
  for (const Arrived& diagnosis : diagnoses_) {
    const Push& push = pushes_[PushAt(diagnosis.stamp)];
    // An incomplete episode may have ended otherwise.
    if (!IsTouched(push)) latencies.push_back(1000.0 * (diagnosis.time - push.end).toSec());
  }
  return latencies;
}

bool DrivenRobot::IsTouched(const Push& push) const {
  const double begin = samples_[push.open].time - kReach;
  const double end = samples_[push.close].time + kReach;
  const auto within = [&](double from, double to) { return from <= end && to >= begin; };
  return within(faults_.step_at, faults_.step_at) || within(faults_.restart_at, faults_.restart_at + faults_.pause);
}

/// What docs/time.md promises. A thread of a node wakes as late as the one that sends: that is the jitter.
double DrivenRobot::Tolerance(const Push& push) const {
  if (stamped_) return 0.5 / rate_;
  const auto second = static_cast<std::size_t>(rate_);
  const std::size_t end = std::min(samples_.size(), push.close + second / 10);
  double jitter = 0.0;
  for (std::size_t index = push.open - std::min(push.open, second); index < end; ++index) {
    jitter = std::max(jitter, samples_[index].lateness);
  }
  return kPlainTolerance + 0.5 * jitter + 0.5 / rate_;
}

/// Whether the force is one of those in a sample period from the stamp `from` on, give or take the tolerance.
bool DrivenRobot::HasForce(float force, std::int64_t from, double tolerance, const Push& push) const {
  // One sample more at either end: an episode may interpolate.
  const double margin = tolerance + 1.0 / rate_;
  const auto before = static_cast<std::size_t>(rate_ * margin) + 2;
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  const std::size_t end = std::min(samples_.size(), push.close + before);
  for (std::size_t index = push.open - std::min(push.open, before); index < end; ++index) {
    const std::int64_t stamp = samples_[index].stamp;
    if (stamp < from - ToNanoseconds(margin) || stamp > from + ToNanoseconds(0.01 + margin)) continue;
    least = std::min(least, std::abs(samples_[index].force));
    greatest = std::max(greatest, std::abs(samples_[index].force));
  }
  return force >= least - 1e-3 && force <= greatest + 1e-3;
}

void DrivenRobot::Judge(const Push& push, const std::vector<Episode>& episodes, Outcome* outcome) const {
  const std::int64_t open = samples_[push.open].stamp;
  const std::int64_t close = samples_[push.close].stamp;
  const double tolerance = Tolerance(push);
  int complete = 0;
  for (const Episode& episode : episodes) {
    if (episode.complete == 0U) continue;
    ++complete;
    const double duration = episode.sample_period * static_cast<double>(episode.force.size());
    const double open_error = 1e-9 * static_cast<double>(StampOf(episode.header) - open);
    // An episode is cut to whole sample periods.
    const double close_error = open_error + duration - 1e-9 * static_cast<double>(close - open);
    const double error = std::max({std::abs(open_error), close_error, -close_error - episode.sample_period});
    const bool right =
        error <= tolerance && HasForce(episode.force.front(), open, tolerance, push) &&
        HasForce(episode.force.back(), open + ToNanoseconds(duration - episode.sample_period), tolerance, push);
    outcome->greatest_error = std::max(outcome->greatest_error, error);
    outcome->greatest_part = std::max(outcome->greatest_part, error / tolerance);
    ++(right ? outcome->right : outcome->wrong);
    if (right) continue;
    std::printf("wrong: %s, push at %.3f s: edges off by %.2f and %.2f ms, tolerance %.2f ms, forces %.2f to %.2f N\n",
                name_.c_str(), samples_[push.open].time, 1000.0 * open_error, 1000.0 * close_error, 1000.0 * tolerance,
                static_cast<double>(episode.force.front()), static_cast<double>(episode.force.back()));
  }
  if (complete == 1) return;
  ++(IsTouched(push) && complete == 0 ? outcome->incomplete : outcome->lost);
  if (IsTouched(push) && complete == 0) return;
  std::printf("lost: %s, push at %.3f s: %zu episodes, %d of them complete\n", name_.c_str(), samples_[push.open].time,
              episodes.size(), complete);
}

Outcome DrivenRobot::Compare() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Outcome outcome;
  if (pushes_.empty()) return outcome;
  std::map<std::size_t, std::vector<Episode>> of_push;
  for (const Episode& episode : episodes_) of_push[PushAt(StampOf(episode.header))].push_back(episode);
  for (std::size_t index = 0; index < pushes_.size(); ++index) Judge(pushes_[index], of_push[index], &outcome);
  return outcome;
}

}  // namespace contact_shapelets::benchmark
