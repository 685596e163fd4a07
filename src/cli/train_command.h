#pragma once

#include <CLI/CLI.hpp>

namespace contact_shapelets::cli {

/// Adds `train BAG... --model OUT.bag`: learns a model from the episodes of bags.
void AddTrainCommand(CLI::App* app);

}  // namespace contact_shapelets::cli
