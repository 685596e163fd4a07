#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "contact_shapelets/core/learner_options.h"
#include "contact_shapelets/core/shapelet.h"

/// \file
/// NN-STNE: learns banks of shapelets from series without labels (sections III.A and III.B of the paper).

namespace contact_shapelets::core {

/// One bank: shapelets that started with equal length.
struct ShapeletBank {
  double scale = 0.0;         ///< the bank's entry of LearnerOptions::scales
  Eigen::MatrixXf shapelets;  ///< [K, M], one per row, before leading and trailing zeros are cut
  double objective = 0.0;     ///< equation 6 at the last step, without its L1 term
};

/// What the learner reports after each step; false stops the learning.
using StepCallback = std::function<bool(int bank, int step, double objective)>;

/// K = round(log2(N (Q - M) C)), equation 1; at least 2.
int ShapeletCount(int series_count, int series_length, int shapelet_length, int clusters);

/// Learns one bank per scale from `series`, which may differ in length (each of 2 or more finite values).
///
/// A scale is left out where it has fewer than 2K windows that are not flat. The result depends on the seed, not on
/// `threads` (1 or more). Returns the banks in the order of the scales, none where no scale has enough
/// windows; fewer where `on_step` stopped it. \throws std::invalid_argument where options are out of range.
std::vector<ShapeletBank> LearnBanks(const std::vector<Eigen::VectorXf>& series, int clusters,
                                     const LearnerOptions& options, std::uint64_t seed, int threads,
                                     const StepCallback& on_step = nullptr);

/// The shapelets of `banks`, leading and trailing zeros cut (never below `shortest` samples) and z-normalised.
std::vector<Shapelet> CutShapelets(const std::vector<ShapeletBank>& banks, int shortest);

}  // namespace contact_shapelets::core
