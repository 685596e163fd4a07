#pragma once

#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/trainer.h"

namespace contact_shapelets::core {

/// Returns the id of the model that a training makes from `episodes` and `options`: 16 hexadecimal digits.
///
/// The id is a digest (FNV-1a) of the number and lengths of the episodes, their forces in whole mN, the first sample
/// period, all options that change the model, the seed, and the version of the algorithm. It does not depend on the
/// learned values: their last bits differ between compilers and processors, so one training would have two ids.
std::string TrainingDigest(const std::vector<Episode>& episodes, const TrainerOptions& options);

}  // namespace contact_shapelets::core
