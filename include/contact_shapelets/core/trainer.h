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
/// From episodes to a model: shapelet banks, clusters, names and novelty limits. The trainer node, the offline program
/// and the evaluation all use it.

namespace contact_shapelets::core {

/// Parameters of TrainModel().
struct TrainerOptions {
  int clusters = 3;        ///< number of clusters C, [2, kMostClusters]
  LearnerOptions learner;  ///< parameters of the shapelet banks
  /// True: cluster on the logarithm of the distances. False: on the distances, as the paper does.
  bool log_distances = true;
  int kmeans_restarts = 20;  ///< starts of the K-means that the decision begins with, [1, 1000]
  /// Voters on the clusters, [0, 2000]. Most see distances to the learned shapelets, the others to random shapelets.
  /// 0: one K-means on the learned shapelets decides.
  int voters = 200;
  int random_shapelets = 1000;  ///< random shapelets that vote beside the learned ones, [0, 10000]
  /// Greatest number of episodes to vote on, [clusters, 50000]. Of more episodes, this many are drawn; the others go
  /// to the nearest centroid of these.
  int voting_episodes = 5000;
  bool incomplete = false;        ///< learn from episodes that lack samples as well; see TakeIncomplete()
  double novelty_quantile = 1.0;  ///< part of a cluster's training episodes that its novelty limit covers, (0, 1]
  double novelty_margin = 1.5;    ///< factor on that limit, [1, 1000]
  int threads = 0;                ///< [0, 1024]; 0: as many as the machine has; the result does not depend on it
  std::uint64_t seed = 0;         ///< equal seeds give equal models

  /// Returns one line for each invalid parameter, with its name and range; an empty string if all values are valid.
  std::string Faults() const;
};

/// Removes the episodes that are not complete from `episodes`, unless `options` ask for them: half a push, from the end
/// of a bag, looks like another outcome. Returns how many it removed.
/// \throws std::invalid_argument if it removed some and leaves fewer than `options.clusters`.
int TakeIncomplete(const TrainerOptions& options, std::vector<Episode>* episodes);

/// Returns the set-up of the paper: one scale, attraction alone, diversity, length by the L1 norm, every window,
/// K-means on the distances themselves. Equal to config/paper.yaml.
TrainerOptions PaperOptions();

/// Progress of a training.
struct TrainingProgress {
  int bank = 0;                ///< index of the scale in training; the number of scales while clusters are formed
  int step = 0;                ///< gradient step of that bank, from 0
  double objective = 0.0;      ///< value of its objective
  double fraction_done = 0.0;  ///< part of the training that is done, [0, 1]
};

/// Receives progress now and then, in the thread that trains. Returns false to cancel the training.
using ProgressCallback = std::function<bool(const TrainingProgress&)>;

/// A model and the clusters of the training episodes.
struct TrainingResult {
  Model model;             ///< as TrainModel() learned it
  Eigen::VectorXi labels;  ///< [N] cluster of each training episode
};

/// Learns shapelets and clusters from `episodes` without their outcomes. Then names the clusters by the outcomes, if
/// there are any. Episodes must have one sample period and may differ in length.
/// \throws std::invalid_argument if options are out of range, there are fewer episodes than clusters, an episode has
///   fewer than 2 samples, sample periods differ, a value is not finite, all episodes are flat, or no scale has enough
///   windows that are not flat. \throws Cancelled if `progress` cancels it.
TrainingResult TrainModel(const std::vector<Episode>& episodes, const TrainerOptions& options,
                          const ProgressCallback& progress = nullptr);

}  // namespace contact_shapelets::core
