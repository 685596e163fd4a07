#include "core/stream/clock_relation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kBucket = 250'000'000;
/// Number of complete buckets that have to agree on a rise.
constexpr std::size_t kRise = 3;
/// Fewer buckets are too few for a slope.
constexpr std::size_t kSlopeBuckets = 8;
/// [s/s] No clock drifts faster.
constexpr double kGreatestDrift = 0.005;
/// [ns] A smaller error of the line does no harm.
constexpr double kLeastTolerance = 5e6;
constexpr double kSpreadSeconds = 5.0;
constexpr double kGreatestInterval = 0.05;

}  // namespace

void ClockRelation::Restart(Nanoseconds arrival, Nanoseconds delay) {
  size_ = 0;
  slope_ = 0.0;
  spread_ = 0.0;
  spread_duration_ = 0.0;
  was_early_ = false;
  last_stamp_ = arrival - delay;
  complete_ = {};
  steep_buckets_ = 0;
  Open(arrival, delay);
  Fit();
}

bool ClockRelation::Add(Nanoseconds arrival, Nanoseconds delay) {
  const Nanoseconds above = delay - At(arrival);
  const bool early = above < -static_cast<Nanoseconds>(kLeastTolerance);
  // A single early stamp is wrong. Two in a row are right.
  if (early && !std::exchange(was_early_, early)) return false;
  was_early_ = early;
  if (above < 0) delay_ += above;
  FollowSpread(arrival - delay, above);
  Bucket& bucket = buckets_[(first_ + size_ - 1) % kBuckets];
  if (arrival < bucket.begin + kBucket) {
    if (delay < bucket.delay) bucket = {bucket.begin, arrival, delay};
    return false;
  }
  FollowRate(bucket);
  const bool risen = HasRisen();
  if (risen) Keep(kRise);
  Fit();
  Open(arrival, delay);
  return risen;
}

/// Weights each delay by the time since the last stamp. Limits great delays, because a backlog after a stall says
/// nothing about the usual jitter.
void ClockRelation::FollowSpread(Nanoseconds stamp, Nanoseconds above) {
  const double interval = std::clamp(ToSeconds(stamp - last_stamp_), 0.0, kGreatestInterval);
  last_stamp_ = stamp;
  if (interval == 0.0) return;
  spread_duration_ = std::min(kSpreadSeconds, spread_duration_ + interval);
  const double counted = std::clamp(static_cast<double>(above), 0.0, 2.0 * spread_ + kLeastTolerance);
  spread_ += interval / spread_duration_ * (counted - spread_);
}

Nanoseconds ClockRelation::Tolerance() const { return static_cast<Nanoseconds>(kLeastTolerance + 2.0 * spread_); }

void ClockRelation::Open(Nanoseconds arrival, Nanoseconds delay) {
  if (size_ == kBuckets) {
    first_ = (first_ + 1) % kBuckets;
    --size_;
  }
  buckets_[(first_ + size_) % kBuckets] = {arrival, arrival, delay};
  ++size_;
}

/// Returns true if the last buckets are late by nearly the same delay. Falling delays come from a queue that empties.
bool ClockRelation::HasRisen() const {
  if (size_ < kRise) return false;
  Nanoseconds least = BucketAt(size_ - 1).delay;
  Nanoseconds greatest = least;
  for (std::size_t index = size_ - kRise; index < size_; ++index) {
    const Bucket& bucket = BucketAt(index);
    if (!IsLate(bucket.arrival, bucket.delay)) return false;
    least = std::min(least, bucket.delay);
    greatest = std::max(greatest, bucket.delay);
  }
  return greatest - least <= Tolerance();
}

/// A replay at another rate makes all delays grow or fall. A clock that is set moves them once.
void ClockRelation::FollowRate(const Bucket& complete) {
  const Bucket before = std::exchange(complete_, complete);
  if (before.arrival == 0) return;
  const double growth =
      static_cast<double>(complete.delay - before.delay) / static_cast<double>(complete.arrival - before.arrival);
  if (std::abs(growth) <= kGreatestDrift) {
    steep_buckets_ = 0;
    return;
  }
  const bool same = (growth < 0.0) == (rate_ > 1.0);
  steep_buckets_ = same ? std::min(steep_buckets_ + 1, kSteepBuckets) : 1;
  rate_ = 1.0 - growth;
}

void ClockRelation::Keep(std::size_t count) {
  first_ = (first_ + size_ - count) % kBuckets;
  size_ = count;
  spread_ = 0.0;
  spread_duration_ = 0.0;
}

/// Fits the line below all points that has the least mean distance to them: the edge of the lower convex hull that
/// spans the mean arrival (Zhang, Liu and Xia, Clock synchronization algorithms for network measurements, INFOCOM
/// 2002).
void ClockRelation::Fit() {
  std::array<Bucket, kBuckets> hull{};
  std::size_t corners = 0;
  double middle = 0.0;
  origin_ = BucketAt(size_ - 1).arrival;
  const auto x = [this](const Bucket& bucket) { return static_cast<double>(bucket.arrival - origin_); };
  const auto slope = [&](const Bucket& from, const Bucket& to) {
    return static_cast<double>(to.delay - from.delay) / std::max(1.0, x(to) - x(from));
  };
  for (std::size_t index = 0; index < size_; ++index) {
    const Bucket& bucket = BucketAt(index);
    middle += x(bucket) / static_cast<double>(size_);
    while (corners >= 2 && slope(hull[corners - 2], hull[corners - 1]) >= slope(hull[corners - 2], bucket)) --corners;
    hull[corners++] = bucket;
  }
  slope_ = 0.0;
  if (size_ >= kSlopeBuckets) {
    std::size_t right = 1;
    while (right + 1 < corners && x(hull[right]) < middle) ++right;
    slope_ = std::clamp(slope(hull[right - 1], hull[right]), -kGreatestDrift, kGreatestDrift);
  }
  delay_ = BucketAt(size_ - 1).delay;
  for (std::size_t index = 0; index < size_; ++index) {
    const Bucket& bucket = BucketAt(index);
    delay_ = std::min(delay_, bucket.delay - static_cast<Nanoseconds>(slope_ * x(bucket)));
  }
}

}  // namespace contact_shapelets::core
