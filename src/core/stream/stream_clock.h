#pragma once

#include <cstdint>

#include "contact_shapelets/core/time.h"
#include "core/stream/clock_relation.h"

/// \file
/// Which time a wrench sample has: drivers' stamps may be zero, run backward, or come from a clock that is hours off.

namespace contact_shapelets::core {

/// What StreamClock made of one sample.
struct SampleTime {
  /// Whether the sample has a place in the stream.
  enum class Verdict {
    kAccepted,    ///< `time` is after every earlier sample's
    kOutOfOrder,  ///< not after the last one, by stamp and by arrival: to be dropped
    kRestarted,   ///< accepted, as the start of a new stream: a replay that loops, a driver whose clock was set
  };
  Verdict verdict = Verdict::kAccepted;
  Nanoseconds time = 0;   ///< on the clock of the stamps, where the stream has stamps
  bool by_stamp = false;  ///< false where the stamp is missing or wrong: `time` is that of the arrival
};

/// Gives every sample a time that only goes forward, and places arrivals on the same clock.
///
/// A stamp is wrong where it does not go forward, or is earlier than any transport explains. Five of them in a row that
/// keep pace with their arrivals say that the driver's clock was set: the stream starts anew by the new one. Arrivals
/// that go back under stamps that go on, or that stay late, say that this machine's clock was set.
class StreamClock {
 public:
  /// The time of a sample with this header `stamp` (0: none) that arrived at `arrival`.
  SampleTime Resolve(Nanoseconds stamp, Nanoseconds arrival);

  /// True if `stamp` is that of the last sample whose stamp was not wrong.
  bool IsLastStamp(Nanoseconds stamp) const { return stamp != 0 && stamp == last_stamp_; }
  /// True once there was a sample.
  bool has_started() const { return started_; }
  /// Arrival of the first sample of the stream, as it began or restarted.
  Nanoseconds start_arrival() const { return start_arrival_; }
  /// Arrival of the last sample.
  Nanoseconds last_arrival() const { return last_arrival_; }
  /// Time of the last sample.
  Nanoseconds last_time() const { return last_time_; }
  /// True while the last sample came so late that either the transport lags or a clock was set.
  bool is_in_doubt() const { return in_doubt_; }

  /// An arrival on the samples' clock, by the fastest messages: no message that arrived then was sent later.
  Nanoseconds FromArrival(Nanoseconds arrival) const {
    return last_stamp_ == 0 ? arrival : arrival - relation_.At(arrival);
  }
  /// What a message on another connection is later than the fastest, by the best guess; 0 without stamps. Wrenches keep
  /// their order, and wait for one another: their mean is above that.
  Nanoseconds usual_delay() const { return last_stamp_ == 0 ? 0 : relation_.spread() * 3 / 4; }
  /// Arrival less stamp of the fastest messages; 0 without stamps.
  Nanoseconds offset() const { return last_stamp_ == 0 ? 0 : relation_.At(last_arrival_); }
  /// [s/s] that the driver's clock is slow; below 0 where it is fast.
  double drift() const { return last_stamp_ == 0 ? 0.0 : relation_.drift(); }

  /// Samples without a stamp.
  std::int64_t zero_stamps() const { return zero_stamps_; }
  /// Samples with a wrong stamp.
  std::int64_t wrong_stamps() const { return wrong_stamps_; }
  /// How often the driver's clock was set.
  std::int64_t stamp_steps() const { return stamp_steps_; }
  /// How often this machine's clock was set, or the transport became slower for good.
  std::int64_t arrival_steps() const { return arrival_steps_; }
  /// How often time began anew.
  std::int64_t jumps_back() const { return jumps_back_; }

 private:
  /// Samples in a row with stamps that are wrong alike.
  struct Suspects {
    int count = 0;
    Nanoseconds first_stamp = 0;
    Nanoseconds first_arrival = 0;
    Nanoseconds last_stamp = 0;
    Nanoseconds least_delay = 0;
    Nanoseconds greatest_delay = 0;
  };

  bool Fits(Nanoseconds stamp, Nanoseconds arrival) const;
  void TakeFitting(Nanoseconds stamp, Nanoseconds arrival);
  bool ClockWasSet(Nanoseconds stamp, Nanoseconds arrival);
  SampleTime Restart(Nanoseconds stamp, Nanoseconds arrival);

  bool started_ = false;
  bool in_doubt_ = false;
  Nanoseconds start_arrival_ = 0;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_time_ = 0;
  Nanoseconds last_stamp_ = 0;  ///< that was not wrong; 0 before there was one
  Nanoseconds last_delay_ = 0;  ///< arrival less stamp of it
  Nanoseconds interval_ = 0;    ///< typical, of stamps
  ClockRelation relation_;
  Suspects suspects_;
  std::int64_t zero_stamps_ = 0;
  std::int64_t wrong_stamps_ = 0;
  std::int64_t stamp_steps_ = 0;
  std::int64_t arrival_steps_ = 0;
  std::int64_t jumps_back_ = 0;
};

}  // namespace contact_shapelets::core
