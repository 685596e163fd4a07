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

/// Parameters of the shapelet learner. The evaluation uses these defaults.
struct LearnerOptions {
  /// Scales: lengths of the shapelets as parts of the median series, each in (0, 1).
  std::vector<double> scales{0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
  Objective objective = Objective::kContrastive;  ///< weights of the spectral term
  double repulsion = 3.0;                         ///< weight of the repulsion in the contrastive objective, at least 0
  double diversity = 0.0;                         ///< lambda K^2 of equation 6, at least 0
  double sparsity = 0.0;                          ///< beta of equation 6, at least 0; above 0 it shortens shapelets
  double flat_fraction = 0.3;   ///< windows under this part of the series' standard deviation never match, [0, 1)
  int steps = 60;               ///< gradient steps per bank, at least 0
  double learning_rate = 0.01;  ///< learning rate of Adam, above 0
  int batch = 128;              ///< greatest number of series per step, at least 2
  int start_windows = 3000;     ///< greatest number of windows for the K-means start, at least 2
  int shortest = 5;             ///< least number of samples of a shapelet, at least 2

  /// Returns one line for each invalid parameter, with its name and range; an empty string if all values are valid.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
