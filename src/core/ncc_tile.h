#pragma once

/// \file
/// The inner loops of the transform-free kernel, built once per instruction set. Plain pointers only: inline code of the
/// standard library or of Eigen, built here with wide vectors, could end up in programs on machines without them.

namespace contact_shapelets::core::tile {

/// Shapelets that share a pass over the series: their values are interleaved, shapelet by shapelet for each sample.
constexpr int kGroup = 4;
/// Readable floats that every array must have behind its last used value, and that positions are rounded up to.
constexpr int kPadding = 64;

/// sums[i * stride + p] = sum_m shapelets[kGroup m + i] series[p + m], for 0 <= p < count (rounded up), i < kGroup.
using FullOverlap = void (*)(const float* series, const float* shapelets, int length, int count, int stride,
                             float* sums);

/// Partial overlaps, from the one before the full one downward, `steps` of them.
///
/// At step n the sample `first + direction n` of each shapelet leaves the overlap, and position p belongs to the window
/// p + window + direction n; the windows' scale is 1 / (M sigma), their offset mu / (M sigma). With A the sum that is left
/// and S[n] the sum of the shapelet's values within, the value is A scale - S[n] offset; greatest[i stride + p] becomes the
/// largest one over all steps, at least 0. `within` is interleaved as the shapelets are.
struct PartialArguments {
  const float* series;     ///< at position 0
  const float* shapelets;  ///< interleaved
  const float* within;     ///< [steps], interleaved
  const float* scale;      ///< of window 0
  const float* offset;     ///< of window 0
  const float* sums;       ///< full overlaps at position 0
  float* greatest;         ///< at position 0
  int first;
  int direction;
  int window;
  int steps;
  int begin;   ///< first position
  int count;   ///< positions (rounded up)
  int stride;  ///< between shapelets in `sums` and `greatest`
};
using PartialOverlaps = void (*)(const PartialArguments& arguments);

/// The loops for one instruction set.
struct Loops {
  const char* name;
  FullOverlap full_overlap;
  PartialOverlaps partial_overlaps;
};

/// What every machine of this architecture runs.
Loops BaselineLoops();
#if defined(__x86_64__)
/// For machines with AVX2 and FMA.
Loops Avx2Loops();
/// For machines with AVX-512 F, VL, DQ and BW.
Loops Avx512Loops();
#endif

}  // namespace contact_shapelets::core::tile
