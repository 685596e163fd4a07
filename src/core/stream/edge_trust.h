#pragma once

#include <map>
#include <optional>
#include <string>

#include "contact_shapelets/core/time.h"

/// \file
/// Decides whether the stamps of edges are on the clock of the wrench.

namespace contact_shapelets::core {

/// Judges each sender of stamped edges by the lateness of its edges: arrival minus stamp.
///
/// A transport makes edges -20 to 100 ms late. Other latenesses come from a slow sender or from a clock that is off.
/// The next edge tells which: a clock that is off makes all edges late by the same time.
class EdgeTrust {
 public:
  /// Returns true if the clock of `sender` is off: this lateness is unusual and close to the one before, or greater
  /// than `longest` in either direction.
  bool IsClockOff(const std::string& sender, Nanoseconds lateness, Nanoseconds longest);

 private:
  std::map<std::string, Nanoseconds> last_lateness_;
};

}  // namespace contact_shapelets::core
