#pragma once

#include <algorithm>

#include "contact_shapelets/core/time.h"

/// \file
/// Gives arrivals on a clock that nobody sets.

namespace contact_shapelets {

/// A reading of this machine's two clocks at one moment.
struct ClockReading {
  core::Nanoseconds system = 0;  ///< the clock of ROS, which may be set
  core::Nanoseconds steady = 0;  ///< its start has no meaning
};

/// Arrivals begin at the system time of the first reading and advance by the steady clock. So no time passes if the
/// system clock is set.
///
/// ROS gives the receipt of a message by the system clock only. The age of the message is the reading now minus the
/// receipt. If the system clock was set between these, the age is wrong. So it has a limit: Look() is called before
/// each batch of messages, and a message of a batch came after the look before the last.
class ArrivalClock {
 public:
  /// Takes a reading before a batch of messages.
  void Look(const ClockReading& now) {
    if (start_.system == 0) start_ = now;
    before_last_ = last_ == 0 ? Now(now) : last_;
    last_ = Now(now);
  }
  /// Returns the present time.
  core::Nanoseconds Now(const ClockReading& now) const { return start_.system + now.steady - start_.steady; }
  /// Returns the arrival of a message that ROS received at `receipt` by the system clock.
  core::Nanoseconds Of(core::Nanoseconds receipt, const ClockReading& now) const {
    const core::Nanoseconds oldest = std::max<core::Nanoseconds>(0, Now(now) - before_last_);
    return Now(now) - std::clamp<core::Nanoseconds>(now.system - receipt, 0, oldest);
  }

 private:
  ClockReading start_;
  core::Nanoseconds before_last_ = 0;
  core::Nanoseconds last_ = 0;
};

}  // namespace contact_shapelets
