#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "contact_shapelets/core/learner_options.h"
#include "contact_shapelets/core/shapelet.h"

/// \file
/// NN-STNE: learns shapelets from series without labels (sections III.A and III.B of the paper).

namespace contact_shapelets::core {

/// The shapelets learned at one scale.
struct ShapeletBank {
  double scale = 0.0;         ///< as in LearnerOptions::scales
  Eigen::MatrixXf shapelets;  ///< [K, M], one per row, before leading and trailing zeros are cut
  double objective = 0.0;     ///< equation 6 at the last step, without its L1 term
};

/// Receives the index of the scale, the step and its objective after each step. Returns false to stop the learning.
using StepCallback = std::function<bool(int bank, int step, double objective)>;

/// Returns K = round(log2(N (Q - M) C)), equation 1; at least 2.
int ShapeletCount(int series_count, int series_length, int shapelet_length, int clusters);

/// Learns one bank per scale from `series`, which may differ in length (each of 2 or more finite values).
///
/// Returns the banks in the order of the scales. Leaves out a scale if its start finds fewer than 2K windows that are
/// not flat; if `on_step` stops the learning, also the scale in work and those after it. The result depends on the
/// seed, not on `threads` (1 or more). \throws std::invalid_argument if options are out of range, there are fewer than
/// 2 series, or a series has fewer than 2 values or one that is not finite.
std::vector<ShapeletBank> LearnBanks(const std::vector<Eigen::VectorXf>& series, int clusters,
                                     const LearnerOptions& options, std::uint64_t seed, int threads,
                                     const StepCallback& on_step = nullptr);

/// Returns the shapelets of `banks`: without leading and trailing zeros, but with at least `shortest` samples, and then
/// z-normalised. Leaves out shapelets that are constant.
std::vector<Shapelet> CutShapelets(const std::vector<ShapeletBank>& banks, int shortest);

}  // namespace contact_shapelets::core
