#pragma once

#include <stdexcept>

namespace contact_shapelets::core {

/// Thrown by long work, such as a training or the reading of bags, that its progress callback cancelled.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace contact_shapelets::core
