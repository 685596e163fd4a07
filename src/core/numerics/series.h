#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// Small operations on series that several parts share.

namespace contact_shapelets::core {

/// Population standard deviation of `series` [Q >= 1], taken in double precision.
double StandardDeviation(const Eigen::Ref<const Eigen::VectorXf>& series);

/// `series` less its mean, over its population standard deviation; all zeros where it is constant.
Eigen::VectorXf ZNormalised(const Eigen::Ref<const Eigen::VectorXf>& series);

/// `series` [Q >= 1] by linear interpolation at `length` >= 1 evenly spaced points from its first to its last value.
Eigen::VectorXf StretchedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length);

/// `series` followed by copies of its last value, so that it has `length` values; unchanged where it has as many.
Eigen::VectorXf ExtendedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length);

/// The values first, first + step, first + 2 step, ... of `series`; `first` within it, `step` >= 1.
Eigen::VectorXf EveryNth(const Eigen::Ref<const Eigen::VectorXf>& series, int first, int step);

/// Samples from the first to behind the last of `length` values of which each is `dilation` samples behind the one
/// before.
int Reach(int length, int dilation);

/// The median length of `series` (at least one), the lower one of two.
int MedianLength(const std::vector<Eigen::VectorXf>& series);

}  // namespace contact_shapelets::core
