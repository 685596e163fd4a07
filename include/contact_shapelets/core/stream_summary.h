#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/finding.h"

/// \file
/// The health of a wrench stream: rate, jitter, gaps, repeated and frozen samples, values that are not finite.

namespace contact_shapelets::core {

/// What StreamMonitor counted.
struct StreamSummary {
  std::int64_t samples = 0;            ///< finite samples in order
  std::int64_t not_finite = 0;         ///< dropped: NaN, infinite or above kGreatestForce
  std::int64_t out_of_order = 0;       ///< dropped: not after the sample before
  std::int64_t zero_stamps = 0;        ///< without a stamp
  std::int64_t wrong_stamps = 0;       ///< stamp ran backward, stood still or leapt ahead: placed by arrival
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
  double clock_offset = 0.0;           ///< [s] arrival less stamp
  double least_force = 0.0;            ///< [N] smallest magnitude
  double greatest_force = 0.0;         ///< [N] largest magnitude
  Eigen::Vector3d least_components = Eigen::Vector3d::Zero();     ///< [N] smallest x, y and z
  Eigen::Vector3d greatest_components = Eigen::Vector3d::Zero();  ///< [N] largest x, y and z
};

/// The summary of two laps of a stream, `after` right after `before`.
StreamSummary Joined(const StreamSummary& before, const StreamSummary& after);

/// All that is wrong with a stream; empty if nothing is. The first is the gravest.
std::vector<Finding> FindingsOf(const StreamSummary& summary);

}  // namespace contact_shapelets::core
