#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/finding.h"

/// \file
/// The health of a wrench stream: rate, jitter, gaps, repeated and frozen samples, values that are not finite, clocks
/// that were set, and what is wrong with the episodes that were cut from it.

namespace contact_shapelets::core {

/// Why an episode was dropped (the first two), or is not sound.
enum class EpisodeFault : std::size_t {
  kTooShort,     ///< dropped: shorter than `min_duration`
  kNoSample,     ///< dropped: without a sample
  kStreamEnded,  ///< the wrench or the recording ended first
  kClockSet,     ///< the driver's clock was set within, or time began anew
  kGap,          ///< a gap of more than `max_gap`
  kFrozen,       ///< the sensor held one value
  kZeros,        ///< the sensor gave exact zeros on all axes
  kWrongStamps,  ///< samples whose stamps were wrong
  kClosingLost,  ///< the next one opened before it was closed
  kZeroMoved,    ///< a contact whose force turned out to be that of free air
  kNotTared,     ///< `tare` is `service`, but nothing was tared; counts as complete
  kCount
};
constexpr std::size_t kEpisodeFaults = static_cast<std::size_t>(EpisodeFault::kCount);
/// Episodes with each fault.
using EpisodeFaultCounts = std::array<std::int64_t, kEpisodeFaults>;

/// What was counted of a stream.
struct StreamSummary {
  std::int64_t samples = 0;            ///< finite samples in order
  std::int64_t not_finite = 0;         ///< dropped: NaN, infinite or above kGreatestForce
  std::int64_t out_of_order = 0;       ///< dropped: not after the sample before
  std::int64_t zero_stamps = 0;        ///< without a stamp
  std::int64_t wrong_stamps = 0;       ///< stamp ran backward, stood still or leapt ahead: placed by arrival
  std::int64_t stamp_steps = 0;        ///< the driver's clock was set
  std::int64_t arrival_steps = 0;      ///< this machine's clock was set, or the transport became slower for good
  std::int64_t jumps_back = 0;         ///< time began anew
  std::int64_t repeated = 0;           ///< same force as the sample before, to the last bit
  std::int64_t repeated_messages = 0;  ///< dropped: same force and same stamp as the sample before
  std::int64_t gaps = 0;               ///< intervals above three times the typical one and above 20 ms
  std::int64_t intervals = 0;          ///< outside of gaps
  double duration = 0.0;               ///< [s] first to last sample
  double rate = 0.0;                   ///< [Hz] mean outside of gaps; 0 with fewer than 2 samples
  double jitter = 0.0;                 ///< [s] standard deviation of the intervals outside of gaps
  double longest_interval = 0.0;       ///< [s]
  double longest_frozen = 0.0;         ///< [s] longest run of one repeated value
  double clock_offset = 0.0;           ///< [s] arrival less stamp of the fastest messages
  double clock_drift = 0.0;            ///< [s/s] that the offset grows
  std::int64_t publisher_turns = 0;    ///< a publisher took turns with another one
  EpisodeFaultCounts episode_faults{};
  std::int64_t waiting_edges = 0;      ///< now: without a place, since no wrench came since
  std::int64_t distrusted_edges = 0;   ///< stamped edges that were placed by their arrival, since their clock is off
  double edge_lateness = 0.0;          ///< [s] arrival less stamp of the last of these
  std::int64_t repeated_openings = 0;  ///< while an episode was open
  double least_force = 0.0;            ///< [N] smallest magnitude
  double greatest_force = 0.0;         ///< [N] largest magnitude
  Eigen::Vector3d least_components = Eigen::Vector3d::Zero();     ///< [N] smallest x, y and z
  Eigen::Vector3d greatest_components = Eigen::Vector3d::Zero();  ///< [N] largest x, y and z
};

/// The summary of two laps of a stream, `after` right after `before`.
StreamSummary Joined(const StreamSummary& before, const StreamSummary& after);

/// All that is wrong with a stream; empty if nothing is. Errors come first.
std::vector<Finding> FindingsOf(const StreamSummary& summary);

/// What is wrong with the episodes that were cut from a stream and with the edges that cut it; empty if nothing is.
std::vector<Finding> EpisodeFindingsOf(const StreamSummary& summary);

/// Episodes that were dropped: too short, or without a sample.
std::int64_t DroppedEpisodes(const StreamSummary& summary);

}  // namespace contact_shapelets::core
