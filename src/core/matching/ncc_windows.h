#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

/// \file
/// The two sides of a match: the windows of a series and the shapelets of one length.

namespace contact_shapelets::core {

struct PreparedShapelets;

/// Neighbouring windows. The first and the last are not flat.
struct WindowStretch {
  int first;  ///< index of the first window
  int count;  ///< windows, at least 1
};

/// A series prepared for matching with shapelets of one length: the windows' means and standard deviations.
///
/// Flat windows are left out because noise that is z-normalised matches anything.
class WindowSet {
 public:
  /// Holds no windows until the first Assign().
  WindowSet() = default;

  /// Prepares `series` [Q] for shapelets of `length` samples.
  ///
  /// Windows with a population standard deviation of `flat_deviation` or less (same unit as the series, at least 0) are
  /// flat and never match. So are windows with no more deviation than rounding makes. Statistics are computed in double
  /// precision; the series is copied.
  /// \throws std::invalid_argument if `length` < 2, `length` > Q, or a value is not finite.
  WindowSet(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation);

  /// Replaces the series, as the constructor does; `series` must not be that of this set. Allocates only if its memory
  /// has never been as large.
  void Assign(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation);

  /// Samples M in a window.
  int length() const { return length_; }
  /// Number of windows J = Q - M + 1, flat ones included.
  int window_count() const { return static_cast<int>(inverse_deviation_.size()); }
  /// Number of windows that are not flat.
  int usable_window_count() const { return usable_window_count_; }
  /// The windows without long flat stretches, in order. Every window that is not flat is in one of these.
  const std::vector<WindowStretch>& stretches() const { return stretches_; }
  /// Returns true if window j is flat.
  bool IsFlat(int window) const { return inverse_deviation_[static_cast<std::size_t>(window)] == 0.0; }
  /// The z-normalised window j, M values.
  Eigen::VectorXf NormalisedWindow(int window) const;
  /// The series [Q].
  Eigen::Map<const Eigen::VectorXf> series() const { return {series_.data(), SizeOf(series_)}; }
  /// Window means mu_j [J].
  Eigen::Map<const Eigen::VectorXd> mean() const { return {mean_.data(), SizeOf(mean_)}; }
  /// 1 / sigma_j [J]; 0 marks a flat window.
  Eigen::Map<const Eigen::VectorXd> inverse_deviation() const {
    return {inverse_deviation_.data(), SizeOf(inverse_deviation_)};
  }

 private:
  template <typename Scalar>
  static Eigen::Index SizeOf(const std::vector<Scalar>& values) {
    return static_cast<Eigen::Index>(values.size());
  }
  void FindStatistics(double flat_deviation);
  void FindStretches();

  int length_ = 0;
  int usable_window_count_ = 0;
  std::vector<WindowStretch> stretches_;
  std::vector<float> series_;
  std::vector<double> mean_;
  std::vector<double> inverse_deviation_;
};

/// Shapelets of one length, z-normalised and prepared for matching.
class ShapeletSet {
 public:
  /// Takes `shapelets` [K, M], one per row, and z-normalises each row. A row of equal values matches nothing.
  /// \throws std::invalid_argument if M < 2 or a value is not finite.
  explicit ShapeletSet(const Eigen::Ref<const Eigen::MatrixXf>& shapelets);

  /// Number of shapelets K.
  int count() const { return static_cast<int>(normalised_.cols()); }
  /// Samples M of each.
  int length() const { return static_cast<int>(normalised_.rows()); }
  /// The z-normalised shapelets [M, K], one per column; zeros if a shapelet is constant.
  const Eigen::MatrixXf& normalised() const { return normalised_; }
  /// The shapelets as FindBestMatches() needs them, with the energies that bound partial overlaps. Copies share them.
  const PreparedShapelets& prepared() const { return *prepared_; }

 private:
  Eigen::MatrixXf normalised_;
  std::shared_ptr<const PreparedShapelets> prepared_;
};

}  // namespace contact_shapelets::core
