#pragma once

#include <cstdint>

namespace contact_shapelets::core {

/// Where one segment of a series ends and another begins.
struct ChangePoint {
  std::int64_t index = 0;  ///< first sample of the later segment
  double score = 0.0;      ///< macro F1 in [0, 1] of the votes of nearest neighbours for either side
  double p_value = 1.0;    ///< that such votes come about without a change
};

}  // namespace contact_shapelets::core
