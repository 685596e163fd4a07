#pragma once

#include <ostream>
#include <string>

/// \file
/// Ranges of numbers, for checks of what comes from outside.

namespace contact_shapelets::core {

/// The numbers from `least` to `greatest`, each of which may be left out.
struct Interval {
  double least = 0.0;
  double greatest = 0.0;
  bool without_least = false;
  bool without_greatest = false;

  /// Whether `value` is one of them; NaN is not.
  bool Contains(double value) const {
    return (without_least ? value > least : value >= least) &&
           (without_greatest ? value < greatest : value <= greatest);
  }
  /// Such as "[0, 1)".
  std::string Text() const;
};

/// Writes "<name> must be in <interval><unit>, but is <value>" and a line break to `faults` where `value` is not in
/// `interval`. `unit` is empty or begins with a space.
void CheckRange(const std::string& name, double value, const Interval& interval, std::ostream* faults,
                const std::string& unit = "");

}  // namespace contact_shapelets::core
