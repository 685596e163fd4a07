#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "core/clustering/consensus.h"
#include "core/learning/random_shapelets.h"

/// \file
/// A training with all that it made. The evaluation also needs what is no part of a model.

namespace contact_shapelets::core {

/// What a training made.
struct Training {
  Model model;
  Eigen::VectorXi labels;            ///< [N] cluster of each training episode
  RandomShapelets random_shapelets;  ///< they voted, and are not part of the model
};

/// Trains as TrainModel() does.
Training Train(const std::vector<Episode>& episodes, const TrainerOptions& options,
               const ProgressCallback& progress = nullptr);

/// The clusters [N] that series fall into by vote, given their distances F to the shapelets of the model of `training`
/// and what its random shapelets see, one series per row. Labels are not those of the model's clusters: series are
/// clustered anew, without looking at the training ones. \throws std::invalid_argument where sizes do not match or
/// there are fewer series than clusters.
Eigen::VectorXi VotedLabels(const Training& training, const Eigen::Ref<const Eigen::MatrixXf>& distances,
                            const Eigen::Ref<const Eigen::MatrixXf>& random_distances, const TrainerOptions& options,
                            const VotesCallback& on_votes = nullptr);

}  // namespace contact_shapelets::core
