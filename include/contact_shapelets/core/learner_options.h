#pragma once

#include <string>
#include <vector>

/// \file
/// Parameters of NN-STNE, the shapelet learner.

namespace contact_shapelets::core {

/// Which weights the spectral term has.
enum class Objective {
  kContrastive,  ///< attraction of like and repulsion of unlike series
  kPaper,        ///< the paper's attraction alone
};

/// Lengths of shapelets in one training at the most.
constexpr int kMostScales = 100;

/// Parameters of the shapelet learner. Defaults are those of the documented evaluation. Each has an upper bound, so
/// that a slip of the pen takes neither all memory nor a week.
struct LearnerOptions {
  /// Lengths of the shapelets as parts of the typical series' length, each in (0, 1); 1 to kMostScales of them.
  std::vector<double> scales{0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
  Objective objective = Objective::kContrastive;
  double repulsion = 3.0;       ///< weight of the repulsion in the contrastive objective, [0, 1000]
  double diversity = 0.0;       ///< lambda K^2 of equation 6, [0, 1000]
  double sparsity = 0.0;        ///< beta of equation 6, [0, 1000]; above 0 it shortens shapelets
  double flat_fraction = 0.3;   ///< windows under this part of the series' standard deviation are left out, [0, 1)
  int steps = 60;               ///< gradient steps per bank, [0, 1000000]
  double learning_rate = 0.01;  ///< of Adam, (0, 1]
  int batch = 128;              ///< series per step at the most, [2, 5000]
  int start_windows = 3000;     ///< windows that the K-means start is taken from at the most, [2, 100000]
  int shortest = 5;             ///< samples that a shapelet has at least, [2, 10000]

  /// Every parameter that is out of range, one line each with its name and range; empty where all are well.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
