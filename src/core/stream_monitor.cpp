#include "contact_shapelets/core/stream_monitor.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::core {
namespace {

constexpr double kGapSeconds = 0.02;
constexpr double kFrozenSeconds = 1.0;
constexpr double kRepeatedPart = 0.02;
constexpr double kJitterPart = 0.5;
constexpr double kOffsetSeconds = 0.5;

double Seconds(Nanoseconds time) { return 1e-9 * static_cast<double>(time); }

template <typename... Parts>
std::string Text(const Parts&... parts) {
  std::ostringstream text;
  text << std::setprecision(3);
  (text << ... << parts);
  return text.str();
}

}  // namespace

void StreamMonitor::AddSample(Nanoseconds time, const Eigen::Vector3d& force) {
  const double magnitude = force.norm();
  summary_.least_force = summary_.samples == 0 ? magnitude : std::min(summary_.least_force, magnitude);
  summary_.greatest_force = std::max(summary_.greatest_force, magnitude);
  ++summary_.samples;
  if (!has_last_) {
    has_last_ = true;
    run_start_ = time;
  } else {
    const double interval = Seconds(time - last_time_);
    // The mean so far says what a gap is; the first few intervals say too little.
    if (intervals_ >= 10 && interval > std::max(3.0 * mean_interval_, kGapSeconds)) ++summary_.gaps;
    ++intervals_;
    const double before = interval - mean_interval_;
    mean_interval_ += before / intervals_;
    squared_deviations_ += before * (interval - mean_interval_);
    summary_.duration += interval;
    summary_.longest_interval = std::max(summary_.longest_interval, interval);
    if (force == last_force_) {
      ++summary_.repeated;
      summary_.longest_frozen = std::max(summary_.longest_frozen, Seconds(time - run_start_));
    } else {
      run_start_ = time;
    }
  }
  last_time_ = time;
  last_force_ = force;
}

void StreamMonitor::JumpBack() {
  ++summary_.jumps_back;
  has_last_ = false;
}

void StreamMonitor::SetStamps(int zero_stamps, int backward_stamps, double clock_offset) {
  summary_.zero_stamps = zero_stamps;
  summary_.backward_stamps = backward_stamps;
  summary_.clock_offset = clock_offset;
}

StreamSummary StreamMonitor::Summary() const {
  StreamSummary summary = summary_;
  if (intervals_ > 0 && mean_interval_ > 0.0) {
    summary.rate = 1.0 / mean_interval_;
    summary.jitter = std::sqrt(squared_deviations_ / intervals_);
  }
  return summary;
}

std::vector<std::string> Findings(const StreamSummary& summary) {
  std::vector<std::string> findings;
  const auto find = [&findings](bool wrong, const std::string& text) {
    if (wrong) findings.push_back(text);
  };
  const double repeated_part = summary.samples > 1 ? static_cast<double>(summary.repeated) / (summary.samples - 1) : 0.0;
  const bool all_frozen = summary.samples > 1 && summary.repeated == summary.samples - 1;
  const bool frozen = all_frozen || summary.longest_frozen >= kFrozenSeconds;
  find(summary.samples == 0, "no usable sample");
  find(all_frozen, "frozen sensor: one value for its whole length");
  find(frozen && !all_frozen, Text("frozen sensor: one value for ", summary.longest_frozen, " s"));
  find(!all_frozen && repeated_part >= kRepeatedPart,
       Text("repeated samples: ", 100.0 * repeated_part, " % equal the sample before"));
  find(summary.not_finite > 0, Text(summary.not_finite, " samples NaN or infinite, dropped"));
  find(summary.out_of_order > 0, Text(summary.out_of_order, " samples not after the one before, dropped"));
  find(summary.zero_stamps > 0, Text(summary.zero_stamps, " samples without a stamp: arrival times are used"));
  find(summary.backward_stamps > 0, Text(summary.backward_stamps, " stamps ran backward: arrival times are used"));
  find(summary.jumps_back > 0, Text("time jumped back ", summary.jumps_back, " times"));
  find(summary.gaps > 0, Text(summary.gaps, " gaps, the longest of ", summary.longest_interval, " s"));
  find(std::abs(summary.clock_offset) > kOffsetSeconds,
       Text("stamps are ", summary.clock_offset, " s behind the time of arrival"));
  find(summary.rate > 0.0 && summary.jitter * summary.rate > kJitterPart,
       Text("jitter of ", 1000.0 * summary.jitter, " ms at a mean interval of ", 1000.0 / summary.rate, " ms"));
  return findings;
}

}  // namespace contact_shapelets::core
