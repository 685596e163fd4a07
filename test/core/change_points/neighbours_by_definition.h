#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

namespace contact_shapelets::core {

/// The correlation of the subsequences of `window` samples from i and j on.
inline double CorrelationByDefinition(const Eigen::VectorXd& series, int i, int j, int window) {
  const Eigen::ArrayXd first = series.segment(i, window).array() - series.segment(i, window).mean();
  const Eigen::ArrayXd second = series.segment(j, window).array() - series.segment(j, window).mean();
  return (first * second).sum() / std::sqrt(first.square().sum() * second.square().sum());
}

/// The correlations of subsequence i with its nearest neighbours among the first `count`, in descending order.
inline std::vector<double> NearestByDefinition(const Eigen::VectorXd& series, int i, int count, int window,
                                               int neighbours) {
  std::vector<double> correlations;
  for (int j = 0; j < count; ++j) {
    if (std::abs(i - j) > window / 2) correlations.push_back(CorrelationByDefinition(series, i, j, window));
  }
  std::sort(correlations.begin(), correlations.end(), std::greater<>());
  correlations.resize(neighbours);
  return correlations;
}

}  // namespace contact_shapelets::core
