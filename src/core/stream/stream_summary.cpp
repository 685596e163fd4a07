#include "contact_shapelets/core/stream_summary.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::core {
namespace {

constexpr double kFrozenSeconds = 1.0;
constexpr double kRepeatedPart = 0.02;
constexpr double kJitterPart = 0.5;
/// [s] Greater offsets are not latency.
constexpr double kOffset = 0.5;
/// [s/s] Quartz clocks drift by less.
constexpr double kDrift = 2e-4;
/// [s] A force in free air rests sooner.
constexpr double kBaselineSeconds = 5.0;

/// Returns `value` with three digits, or as an integer from 1000 on instead of 7.2e+03.
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

/// Adds the intervals of `before`, and with them rate and jitter, to those of `joined`.
void JoinIntervals(const StreamSummary& before, StreamSummary* joined) {
  if (before.rate == 0.0) return;
  const StreamSummary after = *joined;
  joined->intervals += before.intervals;
  if (after.rate == 0.0) {
    joined->rate = before.rate;
    joined->jitter = before.jitter;
    return;
  }
  const double part = static_cast<double>(before.intervals) / static_cast<double>(joined->intervals);
  const double difference = 1.0 / before.rate - 1.0 / after.rate;
  joined->rate = 1.0 / (part / before.rate + (1.0 - part) / after.rate);
  joined->jitter = std::sqrt(part * before.jitter * before.jitter + (1.0 - part) * after.jitter * after.jitter +
                             part * (1.0 - part) * difference * difference);
}

/// Widens the ranges of `joined` to hold those of `before`. Replaces them if `before` has the `only` samples.
void JoinForces(const StreamSummary& before, bool only, StreamSummary* joined) {
  joined->least_force = only ? before.least_force : std::min(before.least_force, joined->least_force);
  joined->greatest_force = std::max(before.greatest_force, joined->greatest_force);
  joined->least_components =
      only ? before.least_components : before.least_components.cwiseMin(joined->least_components).eval();
  joined->greatest_components =
      only ? before.greatest_components : before.greatest_components.cwiseMax(joined->greatest_components).eval();
}

/// Adds a finding if something is wrong.
class Finder {
 public:
  explicit Finder(std::vector<Finding>* findings) : findings_(findings) {}
  void operator()(bool wrong, const std::string& text, const char* remedy,
                  Severity severity = Severity::kWarning) const {
    if (wrong) findings_->push_back({severity, text, remedy});
  }

 private:
  std::vector<Finding>* findings_;
};

void SortByGravity(std::vector<Finding>* findings) {
  std::stable_sort(findings->begin(), findings->end(),
                   [](const Finding& one, const Finding& other) { return one.severity > other.severity; });
}

std::string Times(std::int64_t count) { return count == 1 ? "once" : std::to_string(count) + " times"; }

void FindClocks(const StreamSummary& summary, bool all_frozen, const Finder& find) {
  if (summary.clock_rate != 1.0) {
    // All else that is wrong with the clocks follows from this.
    find(true, Text("stamps pass ", summary.clock_rate, " times as fast as this machine's time"),
         "a bag that is replayed at another rate needs /use_sim_time true and rosbag play --clock");
    return;
  }
  find(summary.stamp_steps > 0, "the driver's clock was set " + Times(summary.stamp_steps),
       "synchronise it before the work starts; an episode that was open then is incomplete");
  find(summary.arrival_steps > 0,
       "this machine's clock was set, or the transport became slower, " + Times(summary.arrival_steps),
       "let chrony slew the clock, not set it, while the cell works; triggers follow within a second");
  // The age of a frozen stamp says nothing about the clocks.
  find(!all_frozen && std::abs(summary.clock_offset) > kOffset,
       Text("stamps are ", std::abs(summary.clock_offset), summary.clock_offset > 0.0 ? " s behind" : " s ahead of",
            " the time of arrival"),
       "synchronise the clocks (chrony, PTP); differences of stamps are used, triggers are shifted by the offset");
  find(!all_frozen && std::abs(summary.clock_drift) > kDrift,
       Text("the driver's clock is ", 1e6 * std::abs(summary.clock_drift), " ppm ",
            summary.clock_drift > 0.0 ? "slow" : "fast"),
       "synchronise the clocks (chrony, PTP); triggers follow the drift");
}

/// The text and the remedy of a finding about episodes with a fault.
struct FaultText {
  EpisodeFault fault;
  const char* text;
  const char* remedy;
};

constexpr FaultText kFaultTexts[] = {
    {EpisodeFault::kTooShort, "dropped: shorter than min_duration", "check the trigger, or lower min_duration"},
    {EpisodeFault::kNoSample, "dropped: without a sample", "check that trigger and wrench overlap"},
    {EpisodeFault::kStreamEnded, "incomplete: the wrench or the recording ended first",
     "check the driver, and record until after the last episode"},
    {EpisodeFault::kClockSet, "incomplete: the driver's clock was set, or time began anew",
     "synchronise clocks before the work starts"},
    {EpisodeFault::kGap, "incomplete: a gap in the wrench", "check network and recorder for lost messages"},
    {EpisodeFault::kFrozen, "incomplete: the sensor held one value", "check the sensor and its driver"},
    {EpisodeFault::kZeros, "incomplete: the sensor gave exact zeros",
     "check the driver: near a singularity it may have no estimate"},
    {EpisodeFault::kWrongStamps, "incomplete: wrong stamps of the wrench",
     "look for two publishers on the topic, or a driver that stamps wrongly"},
    {EpisodeFault::kTooLong, "incomplete: not closed within max_duration, and cut there",
     "look for a lost closing edge; raise max_duration if contacts last longer"},
    {EpisodeFault::kClosingLost, "incomplete: the next one opened before it was closed",
     "check the sequencer: each opening needs a closing"},
    {EpisodeFault::kZeroMoved, "incomplete: the sensor's zero moved",
     "tare the sensor only in free air, and start in free air"},
    {EpisodeFault::kNotTared, "not tared", "call ~tare in free air, or use another tare"},
};

std::string Episodes(std::int64_t count) { return std::to_string(count) + (count == 1 ? " episode " : " episodes "); }

}  // namespace

StreamSummary Joined(const StreamSummary& before, const StreamSummary& after) {
  StreamSummary joined = after;
  joined.samples += before.samples;
  joined.not_finite += before.not_finite;
  joined.out_of_order += before.out_of_order;
  joined.zero_stamps += before.zero_stamps;
  joined.wrong_stamps += before.wrong_stamps;
  joined.jumps_back += before.jumps_back;
  joined.stamp_steps += before.stamp_steps;
  joined.arrival_steps += before.arrival_steps;
  joined.publisher_turns += before.publisher_turns;
  joined.distrusted_edges += before.distrusted_edges;
  joined.repeated_openings += before.repeated_openings;
  joined.lost_openings += before.lost_openings;
  for (std::size_t fault = 0; fault < kEpisodeFaults; ++fault)
    joined.episode_faults[fault] += before.episode_faults[fault];
  joined.repeated += before.repeated;
  joined.repeated_messages += before.repeated_messages;
  joined.gaps += before.gaps;
  joined.duration += before.duration;
  joined.longest_interval = std::max(joined.longest_interval, before.longest_interval);
  joined.longest_frozen = std::max(joined.longest_frozen, before.longest_frozen);
  JoinIntervals(before, &joined);
  if (before.samples > 0) JoinForces(before, after.samples == 0, &joined);
  return joined;
}

std::vector<Finding> FindingsOf(const StreamSummary& summary) {
  std::vector<Finding> findings;
  const Finder find(&findings);
  const std::int64_t repeated = summary.repeated + summary.repeated_messages;
  const std::int64_t compared = summary.samples + summary.repeated_messages - 1;
  const double repeated_part = compared > 0 ? static_cast<double>(repeated) / static_cast<double>(compared) : 0.0;
  const bool all_frozen = compared > 0 && repeated == compared;
  const bool frozen = all_frozen || summary.longest_frozen >= kFrozenSeconds;
  const char* const check_sensor =
      "check the sensor, its cable and its driver; such episodes say nothing, leave them out";
  find(summary.samples == 0, "no usable sample", "check that the driver publishes while recording", Severity::kError);
  find(all_frozen, "frozen sensor: one value for its whole length", check_sensor, Severity::kError);
  find(frozen && !all_frozen, Text("frozen sensor: one value for ", summary.longest_frozen, " s"), check_sensor,
       Severity::kError);
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
  find(summary.jumps_back > 0, "time jumped back " + Times(summary.jumps_back),
       "record one run per bag, without a replay that loops");
  find(summary.publisher_turns > 1,
       Text("two publishers on one topic: they took turns ", summary.publisher_turns, " times"),
       "stop one of them, or give each a topic of its own (rosnode info names them)", Severity::kError);
  find(
      summary.gaps > 0, Text(summary.gaps, " gaps, the longest of ", summary.longest_interval, " s"),
      "harmless between episodes; within one it is marked as incomplete: check network and recorder for lost messages");
  find(summary.rate > 0.0 && summary.jitter * summary.rate > kJitterPart,
       Text("jitter of ", 1000.0 * summary.jitter, " ms at a mean interval of ", 1000.0 / summary.rate, " ms"),
       "check the load of the driver's machine, and that stamps are set where the force is measured");
  FindClocks(summary, all_frozen, find);
  SortByGravity(&findings);
  return findings;
}

std::vector<Finding> EpisodeFindingsOf(const StreamSummary& summary) {
  std::vector<Finding> findings;
  const Finder find(&findings);
  for (const FaultText& fault : kFaultTexts) {
    const std::int64_t count = summary.episode_faults[static_cast<std::size_t>(fault.fault)];
    find(count > 0, Episodes(count) + fault.text, fault.remedy);
  }
  find(summary.waiting_edges > 0, Text(summary.waiting_edges, " edges wait for a wrench: no episode can open"),
       "check that the driver publishes");
  find(summary.distrusted_edges > 0,
       Text(summary.distrusted_edges, " stamped edges are ", std::abs(summary.edge_lateness),
            summary.edge_lateness > 0.0 ? " s before" : " s after", " their arrival: arrival times are used"),
       "stamp episode_event by the clock of the wrench's stamps");
  find(summary.repeated_openings > 0, Text(summary.repeated_openings, " openings came while an episode was open"),
       "harmless if the sequencer repeats itself; else a closing was lost, and an episode is too long");
  find(summary.lost_openings > 0, Text(summary.lost_openings, " closings came while no episode was open"),
       "check the sequencer and the recorder: each closing needs an opening, or its episode is lost");
  find(summary.without_baseline > kBaselineSeconds,
       Text("contact: no free-air force in ", summary.without_baseline, " s, because the force never rests"),
       "keep the arm in free air for half a second; if it never rests, use segmentation: trigger");
  return findings;
}

std::int64_t DroppedEpisodes(const StreamSummary& summary) {
  return summary.episode_faults[static_cast<std::size_t>(EpisodeFault::kTooShort)] +
         summary.episode_faults[static_cast<std::size_t>(EpisodeFault::kNoSample)];
}

}  // namespace contact_shapelets::core
