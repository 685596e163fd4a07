#pragma once

#include <map>
#include <optional>
#include <string>

#include "contact_shapelets/core/time.h"

/// \file
/// Whether the stamps of edges are on the clock of the wrench.

namespace contact_shapelets::core {

/// Judges stamped edges by how late they come, for each sender by itself.
///
/// A stamp is on the clock of the wrench if its edge comes as late as a transport makes it, -20 to 100 ms. Later or
/// earlier ones may come from a sender that took its time, or whose clock is off: an offset of clocks is the same for
/// one edge and the next.
class EdgeTrust {
 public:
  /// True if the clock of `sender` is off: its edges come by as much too late or too early as the one before, or by
  /// more than `longest` [s].
  bool IsClockOff(const std::string& sender, Nanoseconds lateness, Nanoseconds longest);

 private:
  std::map<std::string, Nanoseconds> last_lateness_;
};

}  // namespace contact_shapelets::core
