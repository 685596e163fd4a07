#pragma once

#include <memory>
#include <vector>

#include "core/matching/ncc_definition.h"

/// \file
/// Normalised cross-correlation by FFT, as the paper computes it. Tests and benchmarks compare the kernel with it.

namespace contact_shapelets::core {

/// The paper's formulation: one zero-padded cross-correlation by FFT for each window. FFTW runs in single precision and
/// by plan; the shapelets' spectra are computed once. O(J M log M) per shapelet.
class FftwMatcher {
 public:
  /// Plans the transforms for `shapelets`.
  explicit FftwMatcher(const ShapeletSet& shapelets);
  ~FftwMatcher();
  FftwMatcher(FftwMatcher&&) noexcept;
  FftwMatcher& operator=(FftwMatcher&&) noexcept;

  /// Returns K matches. Two threads must not call it at the same time.
  /// \throws std::invalid_argument if the lengths differ.
  std::vector<Match> BestMatches(const WindowSet& windows);

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace contact_shapelets::core
