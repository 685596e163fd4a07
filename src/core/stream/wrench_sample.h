#pragma once

#include <Eigen/Core>

#include "contact_shapelets/core/time.h"

namespace contact_shapelets::core {

/// The force part of one wrench.
struct WrenchSample {
  Nanoseconds time = 0;      ///< on the clock of the wrench's stamps
  Eigen::Vector3d force;     ///< [N] in the sensor's frame
  bool wrong_stamp = false;  ///< the stamp was wrong, so `time` is that of the arrival
};

}  // namespace contact_shapelets::core
