#pragma once

#include <CLI/CLI.hpp>

namespace contact_shapelets::cli {

/// Adds `inspect BAG...`: says what is in bags, what is wrong with it, and what to do about it.
void AddInspectCommand(CLI::App* app);

}  // namespace contact_shapelets::cli
