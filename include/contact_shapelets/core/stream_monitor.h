#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

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

/// Watches a wrench stream, sample by sample, without allocating.
class StreamMonitor {
 public:
  /// Counts a finite sample at `time` with this `force` [N]; times only go forward.
  void AddSample(Nanoseconds time, const Eigen::Vector3d& force);
  /// Counts a sample that was dropped since it held NaN or infinity.
  void AddNotFinite() { ++lap_.not_finite; }
  /// Counts a sample that was dropped since it was out of order.
  void AddOutOfOrder() { ++lap_.out_of_order; }
  /// Whether `force` is that of the last sample, to the last bit.
  bool IsLastForce(const Eigen::Vector3d& force) const { return has_last_ && force == last_force_; }
  /// Counts a message that was dropped since it repeats the last one with its stamp; it came at `time`.
  void AddRepeatedMessage(Nanoseconds time);
  /// Time began anew: intervals start afresh.
  void JumpBack();
  /// Takes over what the sample clock knows of stamps; `clock_offset` in seconds.
  void SetStamps(std::int64_t zero_stamps, std::int64_t wrong_stamps, double clock_offset);

  /// What was counted so far.
  StreamSummary Summary() const;
  /// What was counted since the last call, or since the start. What is typical of the stream stays known.
  StreamSummary TakeLap();

 private:
  void AddInterval(double interval);
  StreamSummary Lap() const;

  StreamSummary before_;  ///< of all laps but the present one
  StreamSummary lap_;     ///< without rate and jitter
  bool has_last_ = false;
  Nanoseconds last_time_ = 0;
  Nanoseconds run_start_ = 0;
  Eigen::Vector3d last_force_ = Eigen::Vector3d::Zero();
  double typical_interval_ = 0.0;
  double mean_interval_ = 0.0;  ///< of the lap, as the next
  double squared_deviations_ = 0.0;
};

/// The summary of two laps of a stream, `after` right after `before`.
StreamSummary Joined(const StreamSummary& before, const StreamSummary& after);

/// Something that is wrong with a stream.
struct StreamFault {
  std::string text;    ///< what is wrong, with figures
  std::string remedy;  ///< what to do about it
};

/// All that is wrong with a stream; empty where nothing is. The first is the gravest.
std::vector<StreamFault> Faults(const StreamSummary& summary);

/// The texts of Faults().
std::vector<std::string> Findings(const StreamSummary& summary);

}  // namespace contact_shapelets::core
