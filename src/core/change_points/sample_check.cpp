#include "core/change_points/sample_check.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

constexpr double kLargestSample = 1e100;

}  // namespace

void CheckSample(double sample, std::int64_t index) {
  if (std::abs(sample) <= kLargestSample) return;  // false for NaN
  std::ostringstream message;
  message << "sample " << index << " of the series is " << sample << ", but must be finite and at most "
          << kLargestSample << " in magnitude";
  throw std::invalid_argument(message.str());
}

}  // namespace contact_shapelets::core
