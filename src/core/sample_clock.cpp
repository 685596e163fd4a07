#include "contact_shapelets/core/sample_clock.h"

#include <algorithm>
#include <cstdlib>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kHalfSecond = 500'000'000;

}  // namespace

SampleTime SampleClock::Resolve(Nanoseconds stamp, Nanoseconds arrival) {
  if (stamp == 0) ++zero_stamps_;
  const bool jumped = started_ && arrival < last_arrival_ - kHalfSecond && (stamp == 0 || stamp < last_stamp_);
  if (!started_ || jumped) {
    Restart(stamp, arrival);
    return {jumped ? SampleTime::Verdict::kJumpedBack : SampleTime::Verdict::kAccepted, last_time_};
  }

  Nanoseconds time = stamp;
  if (stamp == 0) {
    time = FromArrival(arrival);
  } else if (stamp < last_stamp_) {
    ++backward_stamps_;
    time = FromArrival(arrival);
  } else {
    offset_ = std::min(offset_, arrival - stamp);
    last_stamp_ = stamp;
  }
  last_arrival_ = std::max(last_arrival_, arrival);
  if (time <= last_time_) return {SampleTime::Verdict::kOutOfOrder, last_time_};
  last_time_ = time;
  return {SampleTime::Verdict::kAccepted, time};
}

Nanoseconds SampleClock::FromArrival(Nanoseconds arrival) const {
  return std::abs(offset_) > kHalfSecond ? arrival - offset_ : arrival;
}

void SampleClock::Restart(Nanoseconds stamp, Nanoseconds arrival) {
  started_ = true;
  last_stamp_ = stamp;
  last_arrival_ = arrival;
  offset_ = stamp == 0 ? 0 : arrival - stamp;
  last_time_ = stamp == 0 ? arrival : stamp;
}

}  // namespace contact_shapelets::core
