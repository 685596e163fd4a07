#pragma once

#include <CLI/CLI.hpp>

namespace contact_shapelets::cli {

/// Adds `report MODEL.bag BAG... --out DIR`: a page on what a model makes of bags, and a table beside it.
void AddReportCommand(CLI::App* app);

}  // namespace contact_shapelets::cli
