#pragma once

#include <CLI/CLI.hpp>

namespace contact_shapelets::cli {

/// Adds `classify BAG... --model M.bag`: diagnoses the episodes of bags.
void AddClassifyCommand(CLI::App* app);

}  // namespace contact_shapelets::cli
