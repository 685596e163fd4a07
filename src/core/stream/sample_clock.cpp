#include "core/stream/sample_clock.h"

#include <algorithm>
#include <cstdlib>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kHalfSecond = 500'000'000;

}  // namespace

SampleTime SampleClock::Resolve(Nanoseconds stamp, Nanoseconds arrival) {
  const bool jumped = started_ && arrival < last_arrival_ - kHalfSecond && (stamp == 0 || stamp < last_stamp_);
  if (stamp == 0) ++zero_stamps_;
  if (!started_ || jumped) {
    Restart(stamp, arrival);
    return {jumped ? SampleTime::Verdict::kJumpedBack : SampleTime::Verdict::kAccepted, last_time_};
  }

  last_arrival_ = std::max(last_arrival_, arrival);
  Nanoseconds time = arrival - offset_;
  if (stamp != 0 && stamp == last_stamp_ && arrival - last_stamp_arrival_ <= kHalfSecond) {
    return {SampleTime::Verdict::kOutOfOrder, last_time_};
  }
  if (Fits(stamp, arrival)) {
    offset_ = last_stamp_ == 0 ? arrival - stamp : std::min(offset_, arrival - stamp);
    last_stamp_ = stamp;
    last_stamp_arrival_ = arrival;
    suspect_stamp_ = 0;
    time = stamp > last_time_ ? stamp : arrival - offset_;
  } else if (stamp != 0) {
    if (ClockWasSet(stamp, arrival)) {
      const bool back = stamp <= last_time_;
      Restart(stamp, arrival);
      return {back ? SampleTime::Verdict::kJumpedBack : SampleTime::Verdict::kAccepted, last_time_};
    }
    ++wrong_stamps_;
    suspect_stamp_ = stamp;
    suspect_arrival_ = arrival;
  }
  if (time <= last_time_) return {SampleTime::Verdict::kOutOfOrder, last_time_};
  last_time_ = time;
  return {SampleTime::Verdict::kAccepted, time};
}

Nanoseconds SampleClock::FromArrival(Nanoseconds arrival) const {
  return std::abs(offset_) > kHalfSecond ? arrival - offset_ : arrival;
}

bool SampleClock::Fits(Nanoseconds stamp, Nanoseconds arrival) const {
  if (stamp == 0) return false;
  // The first stamp after samples without one has only their arrivals to be judged by.
  if (last_stamp_ == 0) return std::abs(arrival - stamp) <= kHalfSecond;
  return stamp > last_stamp_ && arrival - stamp >= offset_ - kHalfSecond;
}

bool SampleClock::ClockWasSet(Nanoseconds stamp, Nanoseconds arrival) const {
  if (suspect_stamp_ == 0 || stamp <= suspect_stamp_) return false;
  const bool agree = std::abs((stamp - suspect_stamp_) - (arrival - suspect_arrival_)) <= kHalfSecond;
  // Messages that overtook each other run together too, but not far from the rest.
  return agree && std::abs(arrival - stamp - offset_) > kHalfSecond;
}

void SampleClock::Restart(Nanoseconds stamp, Nanoseconds arrival) {
  started_ = true;
  last_stamp_ = stamp;
  last_stamp_arrival_ = arrival;
  last_arrival_ = arrival;
  suspect_stamp_ = 0;
  offset_ = stamp == 0 ? 0 : arrival - stamp;
  last_time_ = stamp == 0 ? arrival : stamp;
}

}  // namespace contact_shapelets::core
