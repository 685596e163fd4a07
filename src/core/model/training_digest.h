#pragma once

#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/trainer.h"

namespace contact_shapelets::core {

/// The id of the model that a training makes of these `episodes` and `options`: 16 hexadecimal digits, a digest
/// (FNV-1a) of the number and lengths of the episodes, their forces in whole mN, the first one's sample period, all
/// options that the model depends on, the seed, and the version of the algorithm. What was learned is not in it: its
/// last bits differ between compilers and processors, so that one training would have two names.
std::string TrainingDigest(const std::vector<Episode>& episodes, const TrainerOptions& options);

}  // namespace contact_shapelets::core
