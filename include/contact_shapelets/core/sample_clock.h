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
    kOutOfOrder,  ///< not after the last sample, by stamp and by arrival: to be dropped
    kJumpedBack,  ///< stamp and arrival both went back (a replay that loops): accepted, as the start of a new stream
  };
  Verdict verdict = Verdict::kAccepted;
  Nanoseconds time = 0;  ///< on the clock of the stamps, where the stream has stamps
};

/// Gives every sample a time that only goes forward, and places arrival times on the same clock.
class SampleClock {
 public:
  /// The time of a sample with this header `stamp` (0: none) that arrived at `arrival`.
  SampleTime Resolve(Nanoseconds stamp, Nanoseconds arrival);

  /// An arrival time on the samples' clock. The clocks' offset counts only beyond half a second: less is latency.
  Nanoseconds FromArrival(Nanoseconds arrival) const;

  /// Least difference of arrival and stamp so far; 0 without stamps.
  Nanoseconds offset() const { return offset_; }
  /// Samples without a stamp.
  int zero_stamps() const { return zero_stamps_; }
  /// Samples whose stamp ran backward while time went on.
  int backward_stamps() const { return backward_stamps_; }

 private:
  void Restart(Nanoseconds stamp, Nanoseconds arrival);

  bool started_ = false;
  Nanoseconds last_stamp_ = 0;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_time_ = 0;
  Nanoseconds offset_ = 0;
  int zero_stamps_ = 0;
  int backward_stamps_ = 0;
};

}  // namespace contact_shapelets::core
