#pragma once

#include <Eigen/Core>

/// \file
/// How long the subsequences are that a series is compared by.

namespace contact_shapelets::core {

/// The shortest window size that SelectWindowSize() returns.
constexpr int kShortestWindow = 10;

/// The window size [samples] of a series by SuSS, summary statistics subsequences (Ermshaus, Schäfer, Leser: Window
/// size selection in unsupervised time series analytics, 2022): the shortest window whose mean, standard deviation and
/// range come, on average over the series, 89 % of the way from those of one sample to those of the whole series.
///
/// At least kShortestWindow, which is also the answer for a constant series and for one shorter than two windows of
/// that size. Values are finite. Takes O(n log n) time.
int SelectWindowSize(const Eigen::Ref<const Eigen::VectorXd>& series);

}  // namespace contact_shapelets::core
