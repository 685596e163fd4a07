#include "core/numerics/interval.h"

#include <sstream>

namespace contact_shapelets::core {
namespace {

/// Enough digits to tell 1000000 from 1000001.
std::string NumberText(double number) {
  std::ostringstream text;
  text.precision(10);
  text << number;
  return text.str();
}

}  // namespace

std::string Interval::Text() const {
  return (without_least ? "(" : "[") + NumberText(least) + ", " + NumberText(greatest) + (without_greatest ? ")" : "]");
}

void CheckRange(const std::string& name, double value, const Interval& interval, std::ostream* faults,
                const std::string& unit) {
  if (interval.Contains(value)) return;
  *faults << name << " must be in " << interval.Text() << unit << ", but is " << NumberText(value) << '\n';
}

}  // namespace contact_shapelets::core
