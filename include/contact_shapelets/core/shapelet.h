#pragma once

#include <Eigen/Core>

namespace contact_shapelets::core {

/// One learned shapelet.
struct Shapelet {
  int scale = 0;           ///< index of the scale (bank) it was learned at
  int dilation = 1;        ///< samples between two of its values, at least 1
  Eigen::VectorXf values;  ///< z-normalised
};

}  // namespace contact_shapelets::core
