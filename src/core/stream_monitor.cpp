#include "contact_shapelets/core/stream_monitor.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::core {
namespace {

constexpr double kGapSeconds = 0.02;
constexpr double kGapFactor = 3.0;
constexpr double kFrozenSeconds = 1.0;
constexpr double kRepeatedPart = 0.02;
constexpr double kJitterPart = 0.5;
constexpr double kOffsetSeconds = 0.5;

double Seconds(Nanoseconds time) { return 1e-9 * static_cast<double>(time); }

/// Three digits, or all before the point: nobody reads 7.2e+03 s.
std::string Shown(double value) {
  std::ostringstream text;
  if (std::abs(value) >= 1000.0) {
    text << std::llround(value);
  } else {
    text << std::setprecision(3) << value;
  }
  return text.str();
}

const char* Shown(const char* text) { return text; }
std::int64_t Shown(std::int64_t count) { return count; }

template <typename... Parts>
std::string Text(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << Shown(parts));
  return text.str();
}

}  // namespace

void StreamMonitor::AddSample(Nanoseconds time, const Eigen::Vector3d& force) {
  const double magnitude = force.norm();
  summary_.least_force = summary_.samples == 0 ? magnitude : std::min(summary_.least_force, magnitude);
  summary_.greatest_force = std::max(summary_.greatest_force, magnitude);
  const bool first = summary_.samples == 0;
  summary_.least_components = first ? force : summary_.least_components.cwiseMin(force).eval();
  summary_.greatest_components = first ? force : summary_.greatest_components.cwiseMax(force).eval();
  ++summary_.samples;
  if (!has_last_) {
    has_last_ = true;
    run_start_ = time;
  } else {
    AddInterval(Seconds(time - last_time_));
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

void StreamMonitor::AddInterval(double interval) {
  summary_.duration += interval;
  summary_.longest_interval = std::max(summary_.longest_interval, interval);
  const double limit = kGapFactor * typical_interval_;
  // The first few intervals say too little of what is typical.
  const bool gap = intervals_ >= 10 && interval > std::max(limit, kGapSeconds);
  // A gap counts for little, but a rate that really changed becomes the typical one.
  const double change = (intervals_ >= 10 ? std::min(interval, limit) : interval) - typical_interval_;
  typical_interval_ += change / static_cast<double>(std::min<std::int64_t>(intervals_ + 1, 100));
  if (gap) {
    ++summary_.gaps;
    return;
  }
  ++intervals_;
  const double before = interval - mean_interval_;
  mean_interval_ += before / static_cast<double>(intervals_);
  squared_deviations_ += before * (interval - mean_interval_);
}

void StreamMonitor::AddRepeatedMessage(Nanoseconds time) {
  ++summary_.repeated_messages;
  summary_.longest_frozen = std::max(summary_.longest_frozen, Seconds(time - run_start_));
}

void StreamMonitor::JumpBack() {
  ++summary_.jumps_back;
  has_last_ = false;
}

void StreamMonitor::SetStamps(std::int64_t zero_stamps, std::int64_t wrong_stamps, double clock_offset) {
  summary_.zero_stamps = zero_stamps;
  summary_.wrong_stamps = wrong_stamps;
  summary_.clock_offset = clock_offset;
}

StreamSummary StreamMonitor::Summary() const {
  StreamSummary summary = summary_;
  if (intervals_ > 0 && mean_interval_ > 0.0) {
    summary.rate = 1.0 / mean_interval_;
    summary.jitter = std::sqrt(squared_deviations_ / static_cast<double>(intervals_));
  }
  return summary;
}

std::vector<StreamFault> Faults(const StreamSummary& summary) {
  std::vector<StreamFault> faults;
  const auto find = [&faults](bool wrong, const std::string& text, const char* remedy) {
    if (wrong) faults.push_back({text, remedy});
  };
  const std::int64_t repeated = summary.repeated + summary.repeated_messages;
  const std::int64_t compared = summary.samples + summary.repeated_messages - 1;
  const double repeated_part = compared > 0 ? static_cast<double>(repeated) / static_cast<double>(compared) : 0.0;
  const bool all_frozen = compared > 0 && repeated == compared;
  const bool frozen = all_frozen || summary.longest_frozen >= kFrozenSeconds;
  const char* const check_sensor =
      "check the sensor, its cable and its driver; such episodes say nothing, leave them out";
  find(summary.samples == 0, "no usable sample", "check that the driver publishes while recording");
  find(all_frozen, "frozen sensor: one value for its whole length", check_sensor);
  find(frozen && !all_frozen, Text("frozen sensor: one value for ", summary.longest_frozen, " s"), check_sensor);
  find(!all_frozen && repeated_part >= kRepeatedPart,
       Text("repeated samples: ", 100.0 * repeated_part, " % equal the sample before",
            summary.repeated_messages > 0 ? ", stamp and all" : ""),
       "usable: values between are interpolated; the driver publishes faster than its sensor measures, lower its rate");
  find(summary.not_finite > 0, Text(summary.not_finite, " samples NaN, infinite or above 1e6 N, dropped"),
       "check the driver: an invalid estimate must not be published");
  find(summary.out_of_order > 0, Text(summary.out_of_order, " samples not after the one before, dropped"),
       "look for two publishers on the topic, or a driver that stamps wrongly");
  find(summary.zero_stamps > 0, Text(summary.zero_stamps, " samples without a stamp: arrival times are used"),
       "let the driver set header.stamp: arrival times carry the network's jitter");
  find(summary.wrong_stamps > 0,
       Text(summary.wrong_stamps, " stamps ran backward, stood still or leapt ahead: arrival times are used"),
       "synchronise the controller's clock, and record one run per bag");
  find(summary.jumps_back > 0, Text("time jumped back ", summary.jumps_back, " times"),
       "record one run per bag, without a replay that loops");
  find(
      summary.gaps > 0, Text(summary.gaps, " gaps, the longest of ", summary.longest_interval, " s"),
      "harmless between episodes; within one it is marked as incomplete: check network and recorder for lost messages");
  // A frozen stamp ages: that says nothing of the clocks.
  find(!all_frozen && std::abs(summary.clock_offset) > kOffsetSeconds,
       Text("stamps are ", std::abs(summary.clock_offset), summary.clock_offset > 0.0 ? " s behind" : " s ahead of",
            " the time of arrival"),
       "synchronise the clocks (chrony, PTP); differences of stamps are used, triggers are shifted by the offset");
  find(summary.rate > 0.0 && summary.jitter * summary.rate > kJitterPart,
       Text("jitter of ", 1000.0 * summary.jitter, " ms at a mean interval of ", 1000.0 / summary.rate, " ms"),
       "check the load of the driver's machine, and that stamps are set where the force is measured");
  return faults;
}

std::vector<std::string> Findings(const StreamSummary& summary) {
  std::vector<std::string> findings;
  for (const StreamFault& fault : Faults(summary)) findings.push_back(fault.text);
  return findings;
}

}  // namespace contact_shapelets::core
