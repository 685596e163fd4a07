#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `report MODEL.bag BAG... --out DIR`: writes a page with a model's diagnoses of bags, and a table beside it.
Command ReportCommand();

}  // namespace contact_shapelets::cli
