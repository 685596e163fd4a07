#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `train BAG... --model OUT.bag`: learns a model from the episodes of bags.
Command TrainCommand();

}  // namespace contact_shapelets::cli
