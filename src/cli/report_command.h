#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `report MODEL.bag BAG... --out DIR`: a page on what a model makes of bags, and a table beside it.
Command ReportCommand();

}  // namespace contact_shapelets::cli
