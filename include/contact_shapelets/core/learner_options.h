#pragma once

#include <string>
#include <vector>

/// \file
/// Parameters of NN-STNE, the shapelet learner.

namespace contact_shapelets::core {

/// The weights of the spectral term.
enum class Objective {
  kContrastive,  ///< attraction of like and repulsion of unlike series
  kPaper,        ///< the paper's attraction alone
};

/// Greatest number of scales in one training.
constexpr int kMostScales = 100;

/// Parameters of the shapelet learner. The evaluation uses these defaults. Upper bounds keep a typing error from taking
/// all memory, or a week.
struct LearnerOptions {
  /// Scales: lengths of the shapelets as parts of the median series, each in (0, 1); 1 to kMostScales of them.
  std::vector<double> scales{0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
  Objective objective = Objective::kContrastive;  ///< weights of the spectral term
  double repulsion = 3.0;                         ///< weight of the repulsion in the contrastive objective, [0, 1000]
  double diversity = 0.0;                         ///< lambda K^2 of equation 6, [0, 1000]
  double sparsity = 0.0;                          ///< beta of equation 6, [0, 1000]; above 0 it shortens shapelets
  double flat_fraction = 0.3;   ///< windows under this part of the series' standard deviation never match, [0, 1)
  int steps = 60;               ///< gradient steps per bank, [0, 1000000]
  double learning_rate = 0.01;  ///< learning rate of Adam, (0, 1]
  int batch = 128;              ///< greatest number of series per step, [2, 5000]
  int start_windows = 3000;     ///< greatest number of windows for the K-means start, [2, 100000]
  int shortest = 5;             ///< least number of samples of a shapelet, [2, 10000]

  /// Returns one line for each invalid parameter, with its name and range; an empty string if all values are valid.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
