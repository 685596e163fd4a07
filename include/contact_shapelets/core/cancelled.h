#pragma once

#include <stdexcept>

namespace contact_shapelets::core {

/// Thrown if the progress callback of long work, such as a training or the reading of bags, cancels it.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace contact_shapelets::core
