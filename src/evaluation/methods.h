#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "evaluation/clusterer.h"

/// \file
/// The methods that an evaluation compares, by name.

namespace contact_shapelets::evaluation {

/// Names of the methods that are compared by default, all known to MakeClusterer().
const std::vector<std::string>& ClustererNames();

/// The method `name`: "kmeans" on the z-normalised series; "dtw" (dtw.h); "dictionary" (dictionary.h); "udfs" (udfs.h)
/// with 5 neighbours, "udfs_k1" to "udfs_k999" with as many; "kshape" (k_shape.h); "uslm" (uslm.h); "nn_stne", this
/// package's trainer with `options`; "nn_stne_paper", the paper's objective and distances with one scale and none of
/// the additions, whatever `options` says. \throws std::invalid_argument naming the methods where there is none of that
/// name.
std::unique_ptr<Clusterer> MakeClusterer(const std::string& name, const core::TrainerOptions& options);

}  // namespace contact_shapelets::evaluation
