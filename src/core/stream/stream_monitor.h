#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/stream_summary.h"

/// \file
/// Computes a StreamSummary sample by sample.

namespace contact_shapelets::core {

/// Watches a wrench stream sample by sample. Allocates no memory.
class StreamMonitor {
 public:
  /// Counts a finite sample at `time` with this `force` [N]. Times only go forward.
  void AddSample(Nanoseconds time, const Eigen::Vector3d& force);
  /// Counts a sample that was dropped because its force is not finite or above kGreatestForce.
  void AddNotFinite() { ++lap_.not_finite; }
  /// Counts a sample that was dropped because it is out of order.
  void AddOutOfOrder() { ++lap_.out_of_order; }
  /// Returns true if `force` equals that of the last sample.
  bool IsLastForce(const Eigen::Vector3d& force) const { return has_last_ && force == last_force_; }
  /// Counts a message that came at `time` and was dropped because it repeats force and stamp of the last.
  void AddRepeatedMessage(Nanoseconds time);
  /// Starts a new stream: the next sample has no interval.
  void Restart() { has_last_ = false; }
  /// Sets the counts that the functions above do not count, as totals since the start.
  void SetTotals(const StreamSummary& totals);

  /// Returns the summary since the start.
  StreamSummary Summary() const;
  /// Returns the summary since the last call, or since the start. Keeps the typical interval.
  StreamSummary TakeLap();

 private:
  void AddInterval(double interval);
  StreamSummary Lap() const;

  StreamSummary before_;  ///< of all earlier laps
  StreamSummary lap_;     ///< without rate and jitter
  bool has_last_ = false;
  Nanoseconds last_time_ = 0;
  Nanoseconds run_start_ = 0;
  Eigen::Vector3d last_force_ = Eigen::Vector3d::Zero();
  double typical_interval_ = 0.0;
  double mean_interval_ = 0.0;       ///< of the lap
  double squared_deviations_ = 0.0;  ///< of the lap
};

}  // namespace contact_shapelets::core
