#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/shapelet.h"

/// \file
/// A trained model: what a classifier needs, and how it came about. Values as in ShapeletModel.msg.

namespace contact_shapelets::core {

/// One cluster in feature space.
struct Cluster {
  Eigen::VectorXf centroid;    ///< [number of features]
  float novelty_limit = 0.0F;  ///< distance from the centroid beyond which an episode is novel, above 0
  int size = 0;                ///< training episodes in it
  std::string label;           ///< the event's name; empty while nobody named it
};

/// How a model was trained.
struct Provenance {
  std::vector<std::string> sources;     ///< bag files
  std::string objective;                ///< "contrastive" or "paper"
  std::vector<double> selected_scales;  ///< as parts of the typical episode's length
  std::uint64_t seed = 0;               ///< of the training
  int training_episodes = 0;            ///< N
  double typical_duration = 0.0;        ///< [s], median of the training episodes
};

/// Shapelets and clusters.
struct Model {
  std::string id;                   ///< unique
  double sample_period = 0.0;       ///< [s] of the episodes that it applies to
  double flat_fraction = 0.3;       ///< windows under this part of the episode's standard deviation are skipped, [0, 1)
  double log_offset = 0.05;         ///< see Features(), [0, 1]
  std::vector<Shapelet> shapelets;  ///< [K], one feature each
  std::vector<Cluster> clusters;    ///< [C]
  Provenance provenance;            ///< how it was trained

  /// The features that clusters are formed on, for distances F, one series per row: log(max(F, 0) + log_offset), or
  /// max(F, 0) if `log_offset` is 0.
  Eigen::MatrixXf Features(const Eigen::Ref<const Eigen::MatrixXf>& distances) const;

  /// The event that `cluster` stands for: its label, or "cluster_<index>" while it has none, or "unknown" for -1.
  std::string EventOf(int cluster) const;

  /// Every fault that keeps the model from being used, one per line; empty where there is none.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
