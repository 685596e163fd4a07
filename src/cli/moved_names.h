#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/model.h"

/// \file
/// Moves the names of an old model's clusters to a new one.

namespace contact_shapelets::cli {

/// Names those clusters of `model` that have no name yet as `old` names their episodes, see core::NameClusters().
/// `labels` [N] are the clusters of the training `episodes` [N]; `old` classifies these on `threads` threads. Episodes
/// that `old` finds unknown, or in a cluster without a name, count against each name. Returns one line for each name
/// that moved, and for each name of `old` that `model` lacks.
std::vector<std::string> MoveNames(const core::Model& old, const std::vector<core::Episode>& episodes,
                                   const Eigen::Ref<const Eigen::VectorXi>& labels, int threads, core::Model* model);

}  // namespace contact_shapelets::cli
