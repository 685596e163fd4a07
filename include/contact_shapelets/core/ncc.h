#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

/// \file
/// Normalised cross-correlation between shapelets and an episode (equations 2 and 3 of the paper).
///
/// For a shapelet s of M samples and a series t of Q samples there are J = Q - M + 1 windows t_j. Both s and t_j are
/// z-normalised over their own M samples (population standard deviation). CC_w is the zero-padded cross-correlation at
/// shift w in [-(M-1), M-1], divided by M:
///
///     CC_w(s, t_j) = 1/M sum_m s^z[m] t_j^z[m + w],   terms outside of 0 <= m + w < M left out.
///
/// The best match is the largest CC_w over all windows j and shifts w.

namespace contact_shapelets::core {

struct PreparedShapelets;

/// The best match of one shapelet within one series.
struct Match {
  float similarity = -1.0F;  ///< max_j max_w CC_w, in [-1, 1]; -1 where no window counts
  std::int32_t window = -1;  ///< j of that maximum, 0 <= j < J; -1 where no window counts
  std::int32_t shift = 0;    ///< w of that maximum, -(M-1) <= w <= M-1
};

/// Neighbouring windows, of which the first and the last are not flat.
struct WindowStretch {
  int first;  ///< index of the first window
  int count;  ///< windows, at least 1
};

/// A series prepared for matching with shapelets of one length: the windows' means and standard deviations.
///
/// Flat windows are left out, since z-normalising mere noise makes it match anything.
class WindowSet {
 public:
  /// No windows, until the first Assign().
  WindowSet() = default;

  /// Prepares `series` [Q] for shapelets of `length` samples.
  ///
  /// Windows with a population standard deviation of `flat_deviation` or less (same unit as the series, at least 0) are
  /// flat and never match. Statistics are taken in double precision; the series is copied.
  /// \throws std::invalid_argument where `length` < 2, `length` > Q, or a value is not finite.
  WindowSet(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation);

  /// Takes another series, not that of this set, in place of the one before, as the constructor does. Memory is kept
  /// and allocated only where it has never been as large.
  void Assign(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation);

  /// Samples M in a window.
  int length() const { return length_; }
  /// Number of windows J = Q - M + 1, flat ones included.
  int window_count() const { return static_cast<int>(inverse_deviation_.size()); }
  /// Number of windows that are not flat.
  int usable_window_count() const { return usable_window_count_; }
  /// What remains when long flat stretches are left out, in order: every window that is not flat is in one of these.
  const std::vector<WindowStretch>& stretches() const { return stretches_; }
  /// True where window j is flat.
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
  /// \throws std::invalid_argument where M < 2 or a value is not finite.
  explicit ShapeletSet(const Eigen::Ref<const Eigen::MatrixXf>& shapelets);

  /// Number of shapelets K.
  int count() const { return static_cast<int>(normalised_.cols()); }
  /// Samples M of each.
  int length() const { return static_cast<int>(normalised_.rows()); }
  /// The z-normalised shapelets [M, K], one per column; a column of zeros where the shapelet was constant.
  const Eigen::MatrixXf& normalised() const { return normalised_; }
  /// The shapelets laid out for FindBestMatches(), with the energies that bound a partial overlap; shared between
  /// copies.
  const PreparedShapelets& prepared() const { return *prepared_; }

 private:
  Eigen::MatrixXf normalised_;
  std::shared_ptr<const PreparedShapelets> prepared_;
};

/// The definition, evaluated sum by sum in double precision: O(J M^2) per shapelet. For tests and as the benchmark's
/// floor. Returns K matches. \throws std::invalid_argument where the lengths differ.
std::vector<Match> BestMatchesByDefinition(const WindowSet& windows, const ShapeletSet& shapelets);

/// The paper's formulation: one zero-padded cross-correlation by FFT per window, in planned single-precision FFTW, the
/// shapelets' spectra computed once. O(J M log M) per shapelet.
class FftwMatcher {
 public:
  /// Plans the transforms for `shapelets`.
  explicit FftwMatcher(const ShapeletSet& shapelets);
  ~FftwMatcher();
  FftwMatcher(FftwMatcher&&) noexcept;
  FftwMatcher& operator=(FftwMatcher&&) noexcept;

  /// Returns K matches. Not safe to call from two threads at the same time.
  /// \throws std::invalid_argument where the lengths differ.
  std::vector<Match> BestMatches(const WindowSet& windows);

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

/// How the transform-free kernel searches.
struct MatchOptions {
  bool prune = true;  ///< skip what the energy bound shows cannot win; the result is the same
};

/// Memory that one search after the other works in. It grows to what the largest of them needed.
class SearchMemory {
 public:
  SearchMemory();
  ~SearchMemory();
  SearchMemory(SearchMemory&&) noexcept;
  SearchMemory& operator=(SearchMemory&&) noexcept;

  struct Arrays;
  /// For FindBestMatches() alone.
  Arrays& arrays() { return *arrays_; }

 private:
  std::unique_ptr<Arrays> arrays_;
};

/// The transform-free kernel: O(Q M) per shapelet before pruning, exact to 1e-5 in single precision.
///
/// `hints` is empty or holds K matches of an earlier, similar search (the previous training step): their similarity is
/// evaluated first, so that the bound prunes from the start. Writes K matches to `matches`, which may be `hints`.
/// Allocates nothing where `memory` and `matches` are large enough from a search before. Several threads may search at
/// the same time, each with a memory and matches of its own.
/// \throws std::invalid_argument where lengths or counts differ.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, SearchMemory* memory, std::vector<Match>* matches);

/// The same in memory of its own.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches);

/// The name of the widest vector instruction set that FindBestMatches uses on this machine, for reports: "avx512",
/// "avx2", ...
const char* KernelInstructionSet();

}  // namespace contact_shapelets::core
