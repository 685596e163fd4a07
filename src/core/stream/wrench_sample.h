#pragma once

#include <Eigen/Core>

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets::core {

/// The force part of one wrench.
struct WrenchSample {
  Nanoseconds time = 0;   ///< on the clock of the wrench's stamps
  Eigen::Vector3d force;  ///< [N] in the sensor's frame
};

}  // namespace contact_shapelets::core
