#pragma once

#include <Eigen/Core>
#include <vector>

namespace contact_shapelets::core {

/// The squared Euclidean distances of series stretched to one length, which all banks of a training share: the
/// similarities of their batches need them at every step.
class SeriesDistances {
 public:
  /// `series` outlive this and are stretched to `length` samples.
  SeriesDistances(const std::vector<Eigen::VectorXf>& series, int length);

  /// SquaredDistances() of the `chosen` series (indices), [C, C].
  Eigen::MatrixXd Among(const std::vector<int>& chosen) const;

 private:
  /// Of more series the table of all would grow beyond what it saves; those that are asked for are computed then.
  static constexpr std::size_t kMostInTable = 2000;

  Eigen::MatrixXd Compute(const std::vector<int>& chosen) const;

  const std::vector<Eigen::VectorXf>& series_;
  int length_;
  Eigen::MatrixXd table_;  ///< [N, N], or empty
};

}  // namespace contact_shapelets::core
