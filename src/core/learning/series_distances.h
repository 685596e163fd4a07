#pragma once

#include <Eigen/Core>
#include <vector>

namespace contact_shapelets::core {

/// The squared Euclidean distances of series, stretched to one length. Every step of every bank of a training needs
/// them for the similarities of its batch, so the banks share them.
class SeriesDistances {
 public:
  /// Stretches `series` to `length` samples. `series` must outlive this object.
  SeriesDistances(const std::vector<Eigen::VectorXf>& series, int length);

  /// Returns SquaredDistances() of the `chosen` series (n indices), [n, n].
  Eigen::MatrixXd Among(const std::vector<int>& chosen) const;

 private:
  /// For more series, a table of all distances costs more than it saves. Among() then computes those that it returns.
  static constexpr std::size_t kMostInTable = 2000;

  Eigen::MatrixXd Compute(const std::vector<int>& chosen) const;

  const std::vector<Eigen::VectorXf>& series_;
  int length_;
  Eigen::MatrixXd table_;  ///< [N, N], or empty
};

}  // namespace contact_shapelets::core
