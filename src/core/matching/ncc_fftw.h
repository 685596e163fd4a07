#pragma once

#include <memory>
#include <vector>

#include "core/matching/ncc_definition.h"

/// \file
/// Normalised cross-correlation as the paper computes it, by FFT. Tests and benchmarks compare the kernel with it.

namespace contact_shapelets::core {

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

}  // namespace contact_shapelets::core
