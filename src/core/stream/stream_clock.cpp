#include "core/stream/stream_clock.h"

#include <algorithm>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kMillisecond = 1'000'000;
/// If arrivals on one connection go back by more, this machine's clock was set.
constexpr Nanoseconds kBackward = kMillisecond;
/// A queue that empties shortens the delay from one stamp to the next by at most this, or by three intervals.
constexpr Nanoseconds kEarly = 20 * kMillisecond;
/// Delays of suspects that are on one clock differ by at most this.
constexpr Nanoseconds kAlike = 100 * kMillisecond;
constexpr int kSuspects = 5;

}  // namespace

SampleTime StreamClock::Resolve(Nanoseconds stamp, Nanoseconds arrival) {
  if (stamp == 0) ++zero_stamps_;
  if (!started_) return Restart(stamp, arrival);
  const bool back = arrival < last_arrival_ - kBackward;
  if (back && (stamp == 0 || stamp <= last_stamp_ || last_stamp_ == 0)) {
    ++jumps_back_;
    suspects_.count = 0;
    return Restart(stamp, arrival);
  }
  if (back) {
    ++arrival_steps_;
    relation_.Restart(arrival, arrival - stamp);
    last_delay_ = arrival - stamp;
  }
  last_arrival_ = back ? arrival : std::max(last_arrival_, arrival);

  const bool fits = Fits(stamp, arrival);
  if (fits) {
    TakeFitting(stamp, arrival);
  } else if (stamp != 0) {
    if (ClockWasSet(stamp, arrival)) {
      ++stamp_steps_;
      return Restart(stamp, arrival);
    }
    ++wrong_stamps_;
    // A stamp that stands still says nothing about the clocks.
    in_doubt_ = stamp != last_stamp_;
  }
  const bool by_stamp = fits && stamp > last_time_;
  const Nanoseconds time = by_stamp ? stamp : FromArrival(arrival);
  if (time <= last_time_) return {SampleTime::Verdict::kOutOfOrder, last_time_, false};
  last_time_ = time;
  return {SampleTime::Verdict::kAccepted, time, by_stamp};
}

bool StreamClock::Fits(Nanoseconds stamp, Nanoseconds arrival) const {
  // The clock of the first stamps after samples without stamps is not known yet.
  if (stamp == 0 || last_stamp_ == 0 || stamp <= last_stamp_) return false;
  const Nanoseconds early = std::max(kEarly, 3 * interval_);
  const Nanoseconds delay = arrival - stamp;
  return delay >= relation_.At(arrival) - early || delay >= last_delay_ - early;
}

void StreamClock::TakeFitting(Nanoseconds stamp, Nanoseconds arrival) {
  const Nanoseconds interval = stamp - last_stamp_;
  // A gap must not change the typical interval much.
  interval_ = interval_ == 0 ? interval : interval_ + (std::min(interval, 3 * interval_) - interval_) / 16;
  last_stamp_ = stamp;
  last_delay_ = arrival - stamp;
  suspects_.count = 0;
  if (relation_.Add(arrival, last_delay_)) ++arrival_steps_;
  in_doubt_ = relation_.IsLate(arrival, last_delay_);
}

bool StreamClock::ClockWasSet(Nanoseconds stamp, Nanoseconds arrival) {
  const Nanoseconds delay = arrival - stamp;
  Suspects& run = suspects_;
  if (run.count == 0 || stamp <= run.last_stamp || std::max(run.greatest_delay, delay) - run.least_delay > kAlike ||
      run.greatest_delay - std::min(run.least_delay, delay) > kAlike) {
    run = {1, stamp, arrival, stamp, delay, delay};
    return false;
  }
  ++run.count;
  run.last_stamp = stamp;
  run.least_delay = std::min(run.least_delay, delay);
  run.greatest_delay = std::max(run.greatest_delay, delay);
  // Delayed messages also come in a row, but all at once.
  return run.count >= kSuspects && 2 * (arrival - run.first_arrival) >= stamp - run.first_stamp;
}

SampleTime StreamClock::Restart(Nanoseconds stamp, Nanoseconds arrival) {
  const SampleTime::Verdict verdict = started_ ? SampleTime::Verdict::kRestarted : SampleTime::Verdict::kAccepted;
  started_ = true;
  in_doubt_ = false;
  start_arrival_ = suspects_.count > 0 ? suspects_.first_arrival : arrival;
  last_arrival_ = arrival;
  last_stamp_ = stamp;
  last_delay_ = arrival - stamp;
  last_time_ = stamp == 0 ? arrival : stamp;
  interval_ = 0;
  relation_.Restart(arrival, suspects_.count > 0 ? suspects_.least_delay : last_delay_);
  suspects_.count = 0;
  return {verdict, last_time_, stamp != 0};
}

}  // namespace contact_shapelets::core
