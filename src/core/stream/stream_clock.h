#pragma once

#include <cstdint>

#include "contact_shapelets/core/time.h"
#include "core/stream/clock_relation.h"

/// \file
/// Decides the time of each wrench sample. Stamps may be zero, run backward or come from a clock that is hours off.

namespace contact_shapelets::core {

/// The time of one sample, as StreamClock decided it.
struct SampleTime {
  /// Whether the sample has a place in the stream.
  enum class Verdict {
    kAccepted,    ///< `time` is after every earlier sample's
    kOutOfOrder,  ///< neither stamp nor arrival is after the last sample: drop it
    kRestarted,   ///< accepted as the start of a new stream: a replay loops, or the driver's clock was set
  };
  Verdict verdict = Verdict::kAccepted;
  Nanoseconds time = 0;   ///< on the clock of the stamps if the stream has stamps, else on that of arrivals
  bool by_stamp = false;  ///< false if the stamp is missing or wrong: `time` is that of the arrival
};

/// Gives every sample a time that only goes forward, and converts arrivals to the same clock.
///
/// A stamp is wrong if it does not go forward, or if it lies farther ahead of its arrival than any transport explains.
/// Five wrong stamps in a row that keep pace with their arrivals mean that the driver's clock was set: the stream
/// starts anew on the new clock. Arrivals that go back while stamps go on, or that stay late, mean that this machine's
/// clock was set.
class StreamClock {
 public:
  /// Returns the time of a sample with this header `stamp` (0: none) that arrived at `arrival`.
  SampleTime Resolve(Nanoseconds stamp, Nanoseconds arrival);

  /// Returns true if `stamp` equals the last right stamp.
  bool IsLastStamp(Nanoseconds stamp) const { return stamp != 0 && stamp == last_stamp_; }
  /// Returns true after the first sample.
  bool has_started() const { return started_; }
  /// Arrival of the first sample since the stream began or restarted.
  Nanoseconds start_arrival() const { return start_arrival_; }
  /// Arrival of the last sample.
  Nanoseconds last_arrival() const { return last_arrival_; }
  /// Time of the last sample.
  Nanoseconds last_time() const { return last_time_; }
  /// Returns true if the last sample came so late that the transport lags or a clock was set.
  bool is_in_doubt() const { return in_doubt_; }

  /// Converts an arrival to the samples' clock by the fastest messages: the latest time at which a message that arrived
  /// then was sent.
  Nanoseconds FromArrival(Nanoseconds arrival) const {
    return last_stamp_ == 0 ? arrival : arrival - relation_.At(arrival);
  }
  /// Estimates the delay of a message on another connection above that of the fastest; 0 without stamps. It is less
  /// than the mean delay of wrenches, because wrenches keep their order and wait for each other.
  Nanoseconds usual_delay() const { return last_stamp_ == 0 ? 0 : relation_.spread() * 3 / 4; }
  /// Arrival minus stamp of the fastest messages; 0 without stamps.
  Nanoseconds offset() const { return last_stamp_ == 0 ? 0 : relation_.At(last_arrival_); }
  /// [s/s] drift of the driver's clock, above 0 if it is slow, below 0 if it is fast; 0 without stamps.
  double drift() const { return last_stamp_ == 0 ? 0.0 : relation_.drift(); }
  /// Time that passes by the stamps in a second of arrivals; 1 if it passes as fast but for drift, and without stamps.
  double rate() const { return last_stamp_ == 0 ? 1.0 : relation_.rate(); }

  /// Number of samples without a stamp.
  std::int64_t zero_stamps() const { return zero_stamps_; }
  /// Number of samples with a wrong stamp.
  std::int64_t wrong_stamps() const { return wrong_stamps_; }
  /// How often the driver's clock was set.
  std::int64_t stamp_steps() const { return stamp_steps_; }
  /// How often this machine's clock was set, or the transport became slower for good.
  std::int64_t arrival_steps() const { return arrival_steps_; }
  /// How often time jumped back.
  std::int64_t jumps_back() const { return jumps_back_; }

 private:
  /// Consecutive samples with wrong stamps that keep pace with their arrivals.
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
  Nanoseconds last_stamp_ = 0;  ///< the last right stamp; 0 before the first
  Nanoseconds last_delay_ = 0;  ///< arrival minus stamp of that sample
  Nanoseconds interval_ = 0;    ///< typical interval of stamps
  ClockRelation relation_;
  Suspects suspects_;
  std::int64_t zero_stamps_ = 0;
  std::int64_t wrong_stamps_ = 0;
  std::int64_t stamp_steps_ = 0;
  std::int64_t arrival_steps_ = 0;
  std::int64_t jumps_back_ = 0;
};

}  // namespace contact_shapelets::core
