#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contact_shapelets/core/cancelled.h"
#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/learner_options.h"
#include "contact_shapelets/core/model.h"

/// \file
/// From episodes to a model: shapelet banks, clusters, names and novelty limits. Used alike by the trainer node, the
/// offline program and the evaluation.

namespace contact_shapelets::core {

/// Parameters of TrainModel().
struct TrainerOptions {
  int clusters = 3;           ///< C, [2, kMostClusters]
  LearnerOptions learner;     ///< shapelet banks
  bool log_distances = true;  ///< cluster on the logarithm of the distances; false: on the distances, as the paper does
  int kmeans_restarts = 20;   ///< of the K-means that the decision begins with, [1, 1000]
  int voters = 200;  ///< see ConsensusLabels(), [0, 2000]: most on the learned shapelets, the others on random ones;
                     ///< 0: one K-means on the former
  int random_shapelets = 1000;    ///< that vote beside the learned ones, [0, 10000]; 0: learned ones alone
  int voting_episodes = 5000;     ///< [clusters, 50000]: of more episodes as many are drawn to be voted on; the others
                                  ///< go to the nearest centroid of those
  bool incomplete = false;        ///< whether to learn from episodes that lack samples, too; see TakeIncomplete()
  double novelty_quantile = 1.0;  ///< (0, 1] of the training distances that a cluster's limit covers
  double novelty_margin = 1.5;    ///< [1, 1000]: factor on that quantile
  int threads = 0;                ///< [0, 1024], 0: all of the machine; the result does not depend on it
  std::uint64_t seed = 0;         ///< equal seeds give equal models

  /// Every parameter that is out of range, one line each with its name and range; empty if all values are valid.
  std::string Faults() const;
};

/// Takes the episodes that are not complete out of `episodes`, unless they are asked for: half a push, from the end of
/// a bag, looks like another outcome. Returns how many it took.
int TakeIncomplete(const TrainerOptions& options, std::vector<Episode>* episodes);

/// The set-up of the paper: one scale, attraction alone, diversity, length by the L1 norm, every window, K-means on the
/// distances themselves. Equal to config/paper.yaml.
TrainerOptions PaperOptions();

/// Progress of a training.
struct TrainingProgress {
  int bank = 0;                ///< being trained, from 0; as many as there are scales: the clusters
  int step = 0;                ///< of that bank
  double objective = 0.0;      ///< its value
  double fraction_done = 0.0;  ///< [0, 1] of the whole
};

/// Called now and then from the training thread; returning false cancels the training.
using ProgressCallback = std::function<bool(const TrainingProgress&)>;

/// A model and how the training episodes fell into its clusters.
struct TrainingResult {
  Model model;
  Eigen::VectorXi labels;  ///< [N] cluster of each training episode
};

/// Learns shapelets and clusters from `episodes`, without using their outcomes; then names clusters by outcomes where
/// there are some. Episodes must share one sample period and may differ in length.
/// \throws std::invalid_argument where options are out of range, there are fewer episodes than clusters, sample periods
///   differ, a value is not finite, or all episodes are flat. \throws Cancelled
TrainingResult TrainModel(const std::vector<Episode>& episodes, const TrainerOptions& options,
                          const ProgressCallback& progress = nullptr);

}  // namespace contact_shapelets::core
