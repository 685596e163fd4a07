#include "contact_shapelets/core/learner_options.h"

#include <sstream>

namespace contact_shapelets::core {

std::string LearnerOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool valid, const char* name, const char* range, double value) {
    if (!valid) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(!scales.empty(), "scales", "a list of at least one number", 0.0);
  for (const double scale : scales) require(scale > 0.0 && scale < 1.0, "scales", "in (0, 1)", scale);
  require(repulsion >= 0.0, "repulsion", "at least 0", repulsion);
  require(diversity >= 0.0, "diversity", "at least 0", diversity);
  require(sparsity >= 0.0, "sparsity", "at least 0", sparsity);
  require(flat_fraction >= 0.0 && flat_fraction < 1.0, "flat_fraction", "in [0, 1)", flat_fraction);
  require(steps >= 0, "steps", "at least 0", steps);
  require(learning_rate > 0.0, "learning_rate", "above 0", learning_rate);
  require(batch >= 2, "batch", "at least 2", batch);
  require(start_windows >= 2, "start_windows", "at least 2", start_windows);
  require(shortest >= 2, "shortest", "at least 2", shortest);
  return faults.str();
}

}  // namespace contact_shapelets::core
