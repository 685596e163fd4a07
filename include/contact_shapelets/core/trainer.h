#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact_shapelets/core/consensus.h"
#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/learner.h"
#include "contact_shapelets/core/model.h"
#include "contact_shapelets/core/random_shapelets.h"

/// \file
/// From episodes to a model: shapelet banks, clusters, names and novelty limits. Used alike by the trainer node, the
/// offline program and the evaluation.

namespace contact_shapelets::core {

/// Parameters of TrainModel().
struct TrainerOptions {
  int clusters = 3;          ///< C, at least 2
  LearnerOptions learner;    ///< shapelet banks
  int kmeans_restarts = 20;  ///< of the K-means that the decision begins with, at least 1
  int voters = 200;  ///< see ConsensusLabels(), at least 0: most on the learned shapelets, the others on random ones;
                     ///< 0: one K-means on the former
  int random_shapelets = 1000;  ///< that vote beside the learned ones, at least 0; 0: learned ones alone
  int voting_episodes = 5000;  ///< at least the clusters: of more episodes as many are drawn to be voted on; the others
                               ///< go to the nearest centroid of those
  double novelty_quantile = 1.0;  ///< (0, 1] of the training distances that a cluster's limit covers
  double novelty_margin = 1.5;    ///< at least 1: factor on that quantile
  int threads = 0;                ///< 0: as many as the machine has; the result does not depend on it
  std::uint64_t seed = 0;         ///< equal seeds give equal models

  /// Every parameter that is out of range, one line each with its name and range; empty where all are well.
  std::string Faults() const;
};

/// Progress of a training.
struct TrainingProgress {
  int candidate = 0;           ///< scale being trained, from 0; as many as there are scales: the clusters
  int step = 0;                ///< of that scale
  double objective = 0.0;      ///< its value
  double fraction_done = 0.0;  ///< [0, 1] of the whole
};

/// Called now and then from the training thread; returning false cancels the training.
using ProgressCallback = std::function<bool(const TrainingProgress&)>;

/// Thrown by TrainModel() where its callback cancelled it.
class TrainingCancelled : public std::runtime_error {
 public:
  TrainingCancelled() : std::runtime_error("the training was cancelled") {}
};

/// A model and how the training episodes fell into its clusters.
struct TrainingResult {
  Model model;
  Eigen::VectorXi labels;            ///< [N] cluster of each training episode
  RandomShapelets random_shapelets;  ///< they voted, and are not part of the model
};

/// The clusters [N] that series fall into by vote, given their distances F to the shapelets of the model of `result`
/// and what its random shapelets see, one series per row. Labels are not those of the model's clusters: series are
/// clustered anew, without looking at the training ones. \throws std::invalid_argument where sizes do not match or
/// there are fewer series than clusters.
Eigen::VectorXi VotedLabels(const TrainingResult& result, const Eigen::Ref<const Eigen::MatrixXf>& distances,
                            const Eigen::Ref<const Eigen::MatrixXf>& random_distances, const TrainerOptions& options,
                            const VotesCallback& on_votes = nullptr);

/// Learns shapelets and clusters from `episodes`, without using their outcomes; then names clusters by outcomes where
/// there are some. Episodes must share one sample period and may differ in length.
/// \throws std::invalid_argument where options are out of range, there are fewer episodes than clusters, sample periods
///   differ, a value is not finite, or all episodes are flat. \throws TrainingCancelled
TrainingResult TrainModel(const std::vector<Episode>& episodes, const TrainerOptions& options,
                          const ProgressCallback& progress = nullptr);

}  // namespace contact_shapelets::core
