#pragma once

#include <array>
#include <cstddef>

#include "contact_shapelets/core/time.h"

/// \file
/// How far two clocks are apart, and how fast they drift, seen through a transport that delays.

namespace contact_shapelets::core {

/// Least delay over time: the line below all pairs of arrival and delay (arrival less stamp) of the last ten seconds.
///
/// No message arrives before it is sent, so that the line is the offset of the clocks plus the least latency, and its
/// slope is their drift. A second delay in a row below the line lowers it. Delays that stay above it alike for three
/// quarters of a second move it up: a clock was set, or the transport became slower.
class ClockRelation {
 public:
  /// Forgets all, and begins with this delay.
  void Restart(Nanoseconds arrival, Nanoseconds delay);
  /// Takes the delay of a message. Returns true where it completes a rise of the line by more than IsLate() calls late.
  bool Add(Nanoseconds arrival, Nanoseconds delay);

  /// The least delay at `arrival`.
  Nanoseconds At(Nanoseconds arrival) const {
    return delay_ + static_cast<Nanoseconds>(slope_ * static_cast<double>(arrival - origin_));
  }
  /// Whether a message with this delay took longer than the transport's usual jitter explains.
  bool IsLate(Nanoseconds arrival, Nanoseconds delay) const { return delay - At(arrival) > Tolerance(); }
  /// What messages are later than the least delay, in the mean.
  Nanoseconds spread() const { return static_cast<Nanoseconds>(spread_); }
  /// Drift of the stamps' clock, [s/s] that delays grow.
  double drift() const { return slope_; }

 private:
  /// The least delay within a quarter of a second.
  struct Bucket {
    Nanoseconds begin = 0;
    Nanoseconds arrival = 0;
    Nanoseconds delay = 0;
  };
  static constexpr std::size_t kBuckets = 40;

  const Bucket& BucketAt(std::size_t index) const { return buckets_[(first_ + index) % kBuckets]; }
  Nanoseconds Tolerance() const;
  void FollowSpread(Nanoseconds stamp, Nanoseconds above);
  void Open(Nanoseconds arrival, Nanoseconds delay);
  bool HasRisen() const;
  void Keep(std::size_t count);
  void Fit();

  std::array<Bucket, kBuckets> buckets_{};  ///< oldest first from `first_` on; the last is being filled
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  Nanoseconds origin_ = 0;
  Nanoseconds delay_ = 0;  ///< of the line at `origin_`
  double slope_ = 0.0;
  double spread_ = 0.0;           ///< [ns] running mean of delays above the line
  double spread_duration_ = 0.0;  ///< [s] that it is the mean of
  bool was_early_ = false;        ///< the last delay was below the line
  Nanoseconds last_stamp_ = 0;
};

}  // namespace contact_shapelets::core
