#pragma once

#include <array>
#include <cstddef>

#include "contact_shapelets/core/time.h"

/// \file
/// Estimates the offset and the drift of two clocks from messages that a transport delays.

namespace contact_shapelets::core {

/// Least delay over time. A delay is arrival minus stamp. The relation is a line below all pairs of arrival and delay
/// of the last ten seconds.
///
/// No message arrives before it is sent. So the line is the offset of the clocks plus the least latency, and its slope
/// is their drift. Two delays in a row below the line lower it. Nearly equal delays above the line for three quarters
/// of a second raise it: a clock was set, or the transport became slower.
class ClockRelation {
 public:
  /// Forgets all, and begins with this delay.
  void Restart(Nanoseconds arrival, Nanoseconds delay);
  /// Takes the delay of a message. Returns true if it raises the line: the last delays were all late by IsLate().
  bool Add(Nanoseconds arrival, Nanoseconds delay);

  /// Returns the least delay at `arrival`.
  Nanoseconds At(Nanoseconds arrival) const {
    return delay_ + static_cast<Nanoseconds>(slope_ * static_cast<double>(arrival - origin_));
  }
  /// Returns true if a message with this delay took longer than the usual jitter of the transport explains.
  bool IsLate(Nanoseconds arrival, Nanoseconds delay) const { return delay - At(arrival) > Tolerance(); }
  /// Mean of the delays above the least delay.
  Nanoseconds spread() const { return static_cast<Nanoseconds>(spread_); }
  /// [s/s] growth of the delays: the drift of the stamps' clock.
  double drift() const { return slope_; }
  /// Time that passes by the stamps in a second of arrivals, if it is no drift: more than 0.5 % from 1 for two seconds.
  /// Else 1.
  double rate() const { return steep_buckets_ >= kSteepBuckets ? rate_ : 1.0; }

 private:
  /// The least delay within a quarter of a second.
  struct Bucket {
    Nanoseconds begin = 0;
    Nanoseconds arrival = 0;
    Nanoseconds delay = 0;
  };
  static constexpr std::size_t kBuckets = 40;
  static constexpr int kSteepBuckets = 8;

  const Bucket& BucketAt(std::size_t index) const { return buckets_[(first_ + index) % kBuckets]; }
  Nanoseconds Tolerance() const;
  void FollowSpread(Nanoseconds stamp, Nanoseconds above);
  void Open(Nanoseconds arrival, Nanoseconds delay);
  bool HasRisen() const;
  void Keep(std::size_t count);
  void FollowRate(const Bucket& complete);
  void Fit();

  std::array<Bucket, kBuckets> buckets_{};  ///< oldest first from `first_` on; the last is being filled
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  Nanoseconds origin_ = 0;
  Nanoseconds delay_ = 0;  ///< of the line, at `origin_`
  double slope_ = 0.0;
  double spread_ = 0.0;           ///< [ns] running mean of delays above the line
  double spread_duration_ = 0.0;  ///< [s] over which `spread_` is the mean
  bool was_early_ = false;        ///< the last delay was below the line
  Nanoseconds last_stamp_ = 0;
  Bucket complete_;        ///< the last complete bucket
  int steep_buckets_ = 0;  ///< consecutive buckets whose delays grew or fell faster than any drift
  double rate_ = 1.0;      ///< of these
};

}  // namespace contact_shapelets::core
