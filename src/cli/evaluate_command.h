#pragma once

#include <CLI/CLI.hpp>

namespace contact_shapelets::cli {

/// Adds `evaluate --data DIR --datasets A,B --methods M,N --seeds 5`: compares methods on data sets with known classes.
void AddEvaluateCommand(CLI::App* app);

}  // namespace contact_shapelets::cli
