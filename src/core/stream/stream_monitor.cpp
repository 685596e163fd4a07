#include "core/stream/stream_monitor.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

constexpr double kGapSeconds = 0.02;
constexpr double kGapFactor = 3.0;

}  // namespace

void StreamMonitor::AddSample(Nanoseconds time, const Eigen::Vector3d& force) {
  const double magnitude = force.norm();
  lap_.least_force = lap_.samples == 0 ? magnitude : std::min(lap_.least_force, magnitude);
  lap_.greatest_force = std::max(lap_.greatest_force, magnitude);
  const bool first = lap_.samples == 0;
  lap_.least_components = first ? force : lap_.least_components.cwiseMin(force).eval();
  lap_.greatest_components = first ? force : lap_.greatest_components.cwiseMax(force).eval();
  ++lap_.samples;
  if (!has_last_) {
    has_last_ = true;
    run_start_ = time;
  } else {
    AddInterval(ToSeconds(time - last_time_));
    if (force == last_force_) {
      ++lap_.repeated;
      lap_.longest_frozen = std::max(lap_.longest_frozen, ToSeconds(time - run_start_));
    } else {
      run_start_ = time;
    }
  }
  last_time_ = time;
  last_force_ = force;
}

void StreamMonitor::AddInterval(double interval) {
  lap_.duration += interval;
  lap_.longest_interval = std::max(lap_.longest_interval, interval);
  const double limit = kGapFactor * typical_interval_;
  // A few intervals do not tell the typical one.
  const std::int64_t known = before_.intervals + lap_.intervals;
  const bool gap = known >= 10 && interval > std::max(limit, kGapSeconds);
  // The limit makes a single gap count little. A lasting change of rate still becomes the typical interval.
  const double change = (known >= 10 ? std::min(interval, limit) : interval) - typical_interval_;
  typical_interval_ += change / static_cast<double>(std::min<std::int64_t>(known + 1, 100));
  if (gap) {
    ++lap_.gaps;
    return;
  }
  ++lap_.intervals;
  const double before = interval - mean_interval_;
  mean_interval_ += before / static_cast<double>(lap_.intervals);
  squared_deviations_ += before * (interval - mean_interval_);
}

void StreamMonitor::AddRepeatedMessage(Nanoseconds time) {
  ++lap_.repeated_messages;
  lap_.longest_frozen = std::max(lap_.longest_frozen, ToSeconds(time - run_start_));
}

void StreamMonitor::SetTotals(const StreamSummary& totals) {
  lap_.zero_stamps = totals.zero_stamps - before_.zero_stamps;
  lap_.wrong_stamps = totals.wrong_stamps - before_.wrong_stamps;
  lap_.jumps_back = totals.jumps_back - before_.jumps_back;
  lap_.stamp_steps = totals.stamp_steps - before_.stamp_steps;
  lap_.arrival_steps = totals.arrival_steps - before_.arrival_steps;
  lap_.publisher_turns = totals.publisher_turns - before_.publisher_turns;
  lap_.distrusted_edges = totals.distrusted_edges - before_.distrusted_edges;
  lap_.repeated_openings = totals.repeated_openings - before_.repeated_openings;
  lap_.lost_openings = totals.lost_openings - before_.lost_openings;
  for (std::size_t fault = 0; fault < kEpisodeFaults; ++fault) {
    lap_.episode_faults[fault] = totals.episode_faults[fault] - before_.episode_faults[fault];
  }
  lap_.clock_offset = totals.clock_offset;
  lap_.clock_drift = totals.clock_drift;
  lap_.clock_rate = totals.clock_rate;
  lap_.without_baseline = totals.without_baseline;
  lap_.edge_lateness = totals.edge_lateness;
  lap_.waiting_edges = totals.waiting_edges;
}

StreamSummary StreamMonitor::Summary() const { return Joined(before_, Lap()); }

StreamSummary StreamMonitor::TakeLap() {
  const StreamSummary lap = Lap();
  before_ = Joined(before_, lap);
  lap_ = StreamSummary();
  lap_.clock_offset = lap.clock_offset;
  mean_interval_ = 0.0;
  squared_deviations_ = 0.0;
  return lap;
}

StreamSummary StreamMonitor::Lap() const {
  StreamSummary lap = lap_;
  if (lap.intervals > 0 && mean_interval_ > 0.0) {
    lap.rate = 1.0 / mean_interval_;
    lap.jitter = std::sqrt(squared_deviations_ / static_cast<double>(lap.intervals));
  }
  return lap;
}

}  // namespace contact_shapelets::core
