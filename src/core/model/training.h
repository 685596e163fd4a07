#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "core/clustering/consensus.h"
#include "core/learning/random_shapelets.h"

/// \file
/// A training with all its results. The evaluation needs some that are not part of a model.

namespace contact_shapelets::core {

/// The results of a training.
struct Training {
  Model model;
  Eigen::VectorXi labels;            ///< [N] cluster of each training episode
  RandomShapelets random_shapelets;  ///< they voted, and are not part of the model
};

/// Trains as TrainModel() does.
Training Train(const std::vector<Episode>& episodes, const TrainerOptions& options,
               const ProgressCallback& progress = nullptr);

/// Returns the clusters [N] of series by vote. The inputs are their distances to the shapelets of the model of
/// `training` and to its random shapelets, one series per row. It clusters the series anew, without the training
/// series, so labels are not those of the model's clusters. \throws std::invalid_argument if sizes do not match or
/// there are fewer series than clusters.
Eigen::VectorXi VotedLabels(const Training& training, const Eigen::Ref<const Eigen::MatrixXf>& distances,
                            const Eigen::Ref<const Eigen::MatrixXf>& random_distances, const TrainerOptions& options,
                            const VotesCallback& on_votes = nullptr);

}  // namespace contact_shapelets::core
