#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/finding.h"

/// \file
/// The health of a wrench stream and of its episodes: rate, jitter, gaps, repeated and frozen samples, values that are
/// not finite, clocks that were set, incomplete episodes.

namespace contact_shapelets::core {

/// Why an episode was dropped (the first two) or may be wrong (the others).
enum class EpisodeFault : std::size_t {
  kTooShort,     ///< dropped: shorter than `min_duration`
  kNoSample,     ///< dropped: without a sample
  kStreamEnded,  ///< the wrench or the recording ended first
  kClockSet,     ///< the driver's clock was set during the episode, or time jumped back
  kGap,          ///< a gap of more than `max_gap`
  kFrozen,       ///< the sensor held one value
  kZeros,        ///< the sensor gave exact zeros on all axes
  kWrongStamps,  ///< samples whose stamps were wrong
  kTooLong,      ///< not closed within `max_duration`, and cut there
  kClosingLost,  ///< the next episode opened before this one was closed
  kZeroMoved,    ///< the force of the contact turned out to be that of free air
  kNotTared,     ///< `tare` is `service`, but nobody called the service; the episode counts as complete
  kCount         ///< number of faults
};
/// Number of faults.
constexpr std::size_t kEpisodeFaults = static_cast<std::size_t>(EpisodeFault::kCount);
/// Number of episodes with each fault; indices are values of EpisodeFault.
using EpisodeFaultCounts = std::array<std::int64_t, kEpisodeFaults>;

/// Counts and statistics of a stream.
struct StreamSummary {
  std::int64_t samples = 0;             ///< finite samples in order
  std::int64_t not_finite = 0;          ///< dropped: NaN, infinite or above kGreatestForce
  std::int64_t out_of_order = 0;        ///< dropped: not later than the sample before
  std::int64_t zero_stamps = 0;         ///< samples without a stamp
  std::int64_t wrong_stamps = 0;        ///< stamps that ran backward, stood still or leapt ahead: placed by arrival
  std::int64_t stamp_steps = 0;         ///< how often the driver's clock was set
  std::int64_t arrival_steps = 0;       ///< how often this machine's clock was set or the transport became slower
  std::int64_t jumps_back = 0;          ///< how often time jumped back
  std::int64_t repeated = 0;            ///< same force as the sample before, to the last bit
  std::int64_t repeated_messages = 0;   ///< dropped: same force and same stamp as the sample before
  std::int64_t gaps = 0;                ///< intervals above three times the typical one and above 20 ms
  std::int64_t intervals = 0;           ///< intervals between samples that are no gaps
  double duration = 0.0;                ///< [s] from the first to the last sample
  double rate = 0.0;                    ///< [Hz] mean outside of gaps; 0 with fewer than 2 samples
  double jitter = 0.0;                  ///< [s] standard deviation of the intervals outside of gaps
  double longest_interval = 0.0;        ///< [s]
  double longest_frozen = 0.0;          ///< [s] longest time with one value
  double clock_offset = 0.0;            ///< [s] arrival minus stamp of the fastest messages
  double clock_drift = 0.0;             ///< [s/s] growth of the offset
  double clock_rate = 1.0;              ///< time by the stamps in a second of arrivals, if it is no drift; else 1
  std::int64_t publisher_turns = 0;     ///< how often two publishers took turns
  EpisodeFaultCounts episode_faults{};  ///< number of episodes with each fault
  std::int64_t waiting_edges = 0;       ///< edges that wait now because no wrench has come
  std::int64_t distrusted_edges = 0;    ///< stamped edges that were placed by arrival because their clock is off
  double edge_lateness = 0.0;           ///< [s] arrival minus stamp of the last distrusted edge
  std::int64_t repeated_openings = 0;   ///< openings that came while an episode was open
  std::int64_t lost_openings = 0;       ///< closings that came while no episode was open
  double without_baseline = 0.0;        ///< [s] time that contact mode waits for a force that rests; 0 once it has one
  double least_force = 0.0;             ///< [N] smallest magnitude
  double greatest_force = 0.0;          ///< [N] largest magnitude
  Eigen::Vector3d least_components = Eigen::Vector3d::Zero();     ///< [N] smallest x, y and z
  Eigen::Vector3d greatest_components = Eigen::Vector3d::Zero();  ///< [N] largest x, y and z
};

/// Returns the summary of two consecutive laps of a stream.
StreamSummary Joined(const StreamSummary& before, const StreamSummary& after);

/// Returns all findings about a stream, errors first.
std::vector<Finding> FindingsOf(const StreamSummary& summary);

/// Returns all findings about the episodes and the edges of a stream.
std::vector<Finding> EpisodeFindingsOf(const StreamSummary& summary);

/// Returns the number of dropped episodes: too short, or without a sample.
std::int64_t DroppedEpisodes(const StreamSummary& summary);

}  // namespace contact_shapelets::core
