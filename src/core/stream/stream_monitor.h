#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/stream_summary.h"

/// \file
/// Counts what StreamSummary holds, sample by sample.

namespace contact_shapelets::core {

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
  /// The stream began anew: intervals start afresh.
  void Restart() { has_last_ = false; }
  /// Takes over what others counted since the start: all of `totals` that no function above counts.
  void SetTotals(const StreamSummary& totals);

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

}  // namespace contact_shapelets::core
