#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contact_shapelets/core/model.h"

/// \file
/// NN-STNE: learns banks of shapelets from series without labels (sections III.A and III.B of the paper).

namespace contact_shapelets::core {

/// Which weights the spectral term has.
enum class Objective {
  kContrastive,  ///< attraction of like and repulsion of unlike series
  kPaper,        ///< the paper's attraction alone
};

/// Parameters of the shapelet learner. Defaults are those of the documented evaluation.
struct LearnerOptions {
  /// Lengths of the shapelets as parts of the typical series' length, each in (0, 1).
  std::vector<double> scales{0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
  Objective objective = Objective::kContrastive;
  double repulsion = 3.0;       ///< weight of the repulsion in the contrastive objective, at least 0
  double diversity = 0.0;       ///< lambda K^2 of equation 6, at least 0
  double sparsity = 0.0;        ///< beta of equation 6, at least 0; above 0 it shortens shapelets
  double flat_fraction = 0.3;   ///< windows under this part of the series' standard deviation are left out, [0, 1)
  int steps = 60;               ///< gradient steps per bank, at least 0
  double learning_rate = 0.01;  ///< of Adam, above 0
  int batch = 128;              ///< series per step at the most, at least 2
  int start_windows = 3000;     ///< windows that the K-means start is taken from at the most, at least 2
  int shortest = 5;             ///< samples that a shapelet has at least, 2 or more

  /// Every parameter that is out of range, one line each with its name and range; empty where all are well.
  std::string Faults() const;
};

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
