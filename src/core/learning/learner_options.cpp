#include "contact_shapelets/core/learner_options.h"

#include <sstream>

#include "core/numerics/interval.h"

namespace contact_shapelets::core {

std::string LearnerOptions::Faults() const {
  std::ostringstream faults;
  const auto check = [&faults](const char* name, double value, const Interval& interval) {
    CheckRange(name, value, interval, &faults);
  };
  check("the number of scales", static_cast<double>(scales.size()), {1, kMostScales});
  for (const double scale : scales) check("scales", scale, {0, 1, true, true});
  check("repulsion", repulsion, {0, 1000});
  check("diversity", diversity, {0, 1000});
  check("sparsity", sparsity, {0, 1000});
  check("flat_fraction", flat_fraction, {0, 1, false, true});
  check("shortest", shortest, {2, 10000});
  check("steps", steps, {0, 1000000});
  check("learning_rate", learning_rate, {0, 1, true});
  check("batch", batch, {2, 5000});
  check("start_windows", start_windows, {2, 100000});
  return faults.str();
}

}  // namespace contact_shapelets::core
