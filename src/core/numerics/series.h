#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// Operations on series that several rooms use.

namespace contact_shapelets::core {

/// Returns the population standard deviation of `series` [Q >= 1], computed in double precision.
double StandardDeviation(const Eigen::Ref<const Eigen::VectorXf>& series);

/// Returns `series` minus its mean, divided by its population standard deviation; all zeros if `series` is constant.
Eigen::VectorXf ZNormalised(const Eigen::Ref<const Eigen::VectorXf>& series);

/// Interpolates `series` [Q >= 1] linearly at `length` >= 1 evenly spaced points from its first to its last value.
Eigen::VectorXf StretchedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length);

/// Returns `series` extended to `length` values by copies of its last value; unchanged if it has as many or more.
Eigen::VectorXf ExtendedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length);

/// Returns the values at first, first + step, first + 2 step, ... of `series`; 0 <= `first` < Q, `step` >= 1.
Eigen::VectorXf EveryNth(const Eigen::Ref<const Eigen::VectorXf>& series, int first, int step);

/// Returns how many samples `length` values span that are `dilation` samples apart: (length - 1) dilation + 1.
int Reach(int length, int dilation);

/// Returns the median length of `series` (at least one). Of two middle lengths it is the shorter one.
int MedianLength(const std::vector<Eigen::VectorXf>& series);

}  // namespace contact_shapelets::core
