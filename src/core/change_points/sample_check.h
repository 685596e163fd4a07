#pragma once

#include <cstdint>

namespace contact_shapelets::core {

/// \throws std::invalid_argument, naming the place `index`, where a sample is not finite or beyond 1e100, so that
/// squares of samples can be summed.
void CheckSample(double sample, std::int64_t index);

}  // namespace contact_shapelets::core
