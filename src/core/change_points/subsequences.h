#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

/// \file
/// What comparing the subsequences of a series needs of each of them.
///
/// The correlation of the z-normalised subsequences i and j is c(i, j) |x_i|^-1 |x_j|^-1, where c is the dot product
/// and
/// |.| the norm after each subsequence's mean was subtracted. Along a diagonal c follows from its predecessor:
/// c(i, j) = c(i-1, j-1) + s_i e_j + s_j e_i with the half step s_i = (x_{i+w-1} - x_{i-1}) / 2 and the edge
/// e_i = (x_{i+w-1} - m_i) + (x_{i-1} - m_{i-1}), m the means (Zimmerman et al.: Matrix profile XIV, 2019). No term is
/// large beside c, however far the series is from zero.
///
/// Where a series repeats itself, many subsequences are equally near, and which of them come first in the series must
/// not decide, or else neighbours would be near in time and any split of the series would seem to part two shapes. So
/// each subsequence's correlations are lowered by up to kTie, at random.

namespace contact_shapelets::core {

/// How many subsequences are compared at once.
constexpr int kLanes = 8;
/// Up to which difference in correlation chance decides which of two subsequences is nearer.
constexpr double kTie = 1e-4;

/// A value for each of kLanes subsequences.
using Lanes = Eigen::Array<double, kLanes, 1>;

/// The subsequences of a growing series: of its samples from i on, for every i.
///
/// A flat subsequence, whose standard deviation is within rounding of zero, has no shape: its correlation with any
/// other is 0. Equal series give equal correlations.
class Subsequences {
 public:
  /// Subsequences of `window` samples, at least 2.
  explicit Subsequences(int window) : window_(window) {}

  /// Appends a sample, and with it a subsequence once there are enough samples.
  void Append(double sample);
  /// Forgets the first `count` samples and subsequences; those that follow move to the front.
  void EraseFirst(int count);

  /// Samples in a subsequence.
  int window() const { return window_; }
  /// How many subsequences there are.
  int size() const { return static_cast<int>(means_.size()); }

  /// Whether subsequence i is flat.
  bool IsFlat(int i) const { return inverse_norms_[i] == 0.0; }
  /// c(i, j) by its definition.
  double Covariance(int i, int j) const;
  /// c(i, j) from c(i - 1, j - 1); i and j at least 1.
  double NextCovariance(int i, int j, double covariance) const {
    return covariance + half_steps_[i] * edges_[j] + half_steps_[j] * edges_[i];
  }
  /// The correlation of i and j by c(i, j), in [-1, 1] but for rounding, lowered by up to 2 kTie of itself.
  double Correlation(int i, int j, double covariance) const {
    return covariance * inverse_norms_[i] * inverse_norms_[j];
  }

  /// NextCovariance() of i with j, j + 1, ..., j + kLanes - 1.
  Lanes NextCovariances(int i, int j, const Lanes& covariances) const {
    return covariances + half_steps_[i] * Of(edges_, j) + edges_[i] * Of(half_steps_, j);
  }
  /// Correlation() of i with j, j + 1, ..., j + kLanes - 1.
  Lanes Correlations(int i, int j, const Lanes& covariances) const {
    return covariances * (inverse_norms_[i] * Of(inverse_norms_, j));
  }

 private:
  static Eigen::Map<const Lanes> Of(const std::vector<double>& values, int first) {
    return Eigen::Map<const Lanes>(values.data() + first);
  }

  int window_;
  std::minstd_rand tie_breaker_;
  std::vector<double> samples_;
  std::vector<double> means_;
  std::vector<double> inverse_norms_;  ///< lowered by chance; 0 of flat subsequences
  std::vector<double> half_steps_;
  std::vector<double> edges_;
};

}  // namespace contact_shapelets::core
