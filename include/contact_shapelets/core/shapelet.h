#pragma once

#include <Eigen/Core>

namespace contact_shapelets::core {

/// One learned shapelet.
struct Shapelet {
  int scale = 0;           ///< index of its scale in Provenance::selected_scales
  int dilation = 1;        ///< samples from one of its values to the next, at least 1
  Eigen::VectorXf values;  ///< z-normalised
};

}  // namespace contact_shapelets::core
