#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "evaluation/clusterer.h"

/// \file
/// The methods that an evaluation compares, by name.

namespace contact_shapelets::evaluation {

/// Returns the names of the methods of a default evaluation.
const std::vector<std::string>& ClustererNames();

/// Returns the method `name`:
///
/// - "kmeans": K-means on the z-normalised series
/// - "dtw": K-medoids under dynamic time warping with a band of a tenth (dtw.h)
/// - "dictionary": shapelet dictionary by sparse coding (dictionary.h)
/// - "udfs": UDFS with 5 neighbours (udfs.h); "udfs_k1" to "udfs_k999": with 1 to 999
/// - "kshape": k-Shape (k_shape.h)
/// - "uslm": USLM (uslm.h)
/// - "nn_stne": this package's trainer with `options`
/// - "nn_stne_paper": the trainer with PaperOptions(), whatever `options` says
///
/// \throws std::invalid_argument that lists the methods if there is none of that name.
std::unique_ptr<Clusterer> MakeClusterer(const std::string& name, const core::TrainerOptions& options);

}  // namespace contact_shapelets::evaluation
