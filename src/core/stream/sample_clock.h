#pragma once

#include "contact_shapelets/core/episode.h"

/// \file
/// Which time a wrench sample has: drivers' stamps may be zero, run backward, or come from a clock that is hours off.

namespace contact_shapelets::core {

/// What SampleClock made of one sample.
struct SampleTime {
  /// Whether the sample has a place in the stream.
  enum class Verdict {
    kAccepted,    ///< `time` is after every earlier sample's
    kOutOfOrder,  ///< the last sample again, or not after it, by stamp and by arrival: to be dropped
    kJumpedBack,  ///< time went back (a replay that loops, a clock that was set): accepted, as the start of a new
                  ///< stream
  };
  Verdict verdict = Verdict::kAccepted;
  Nanoseconds time = 0;  ///< on the clock of the stamps, where the stream has stamps
};

/// Gives every sample a time that only goes forward, and places arrival times on the same clock.
///
/// A stamp is wrong where it runs backward, stands still for longer than half a second, or is more than half a second
/// later than its arrival allows; such a sample is placed by its arrival. Where the stamps of two samples in a row are
/// wrong alike, by more than half a second, the clock was set, and the stream goes on by the new one.
class SampleClock {
 public:
  /// The time of a sample with this header `stamp` (0: none) that arrived at `arrival`.
  SampleTime Resolve(Nanoseconds stamp, Nanoseconds arrival);

  /// True where `stamp` is that of the last sample whose stamp was not wrong.
  bool IsLastStamp(Nanoseconds stamp) const { return stamp != 0 && stamp == last_stamp_; }

  /// An arrival time on the samples' clock. The clocks' offset counts only beyond half a second: less is latency.
  Nanoseconds FromArrival(Nanoseconds arrival) const;

  /// Least difference of arrival and stamp since the clock was set; 0 without stamps.
  Nanoseconds offset() const { return offset_; }
  /// Samples without a stamp.
  std::int64_t zero_stamps() const { return zero_stamps_; }
  /// Samples with a wrong stamp.
  std::int64_t wrong_stamps() const { return wrong_stamps_; }

 private:
  bool Fits(Nanoseconds stamp, Nanoseconds arrival) const;
  bool ClockWasSet(Nanoseconds stamp, Nanoseconds arrival) const;
  void Restart(Nanoseconds stamp, Nanoseconds arrival);

  bool started_ = false;
  Nanoseconds last_stamp_ = 0;  ///< that was not wrong; 0 before there was one
  Nanoseconds last_stamp_arrival_ = 0;
  Nanoseconds suspect_stamp_ = 0;  ///< of the last sample, where that was wrong; else 0
  Nanoseconds suspect_arrival_ = 0;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_time_ = 0;
  Nanoseconds offset_ = 0;
  std::int64_t zero_stamps_ = 0;
  std::int64_t wrong_stamps_ = 0;
};

}  // namespace contact_shapelets::core
