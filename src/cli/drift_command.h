#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `shapelets drift`: tells whether the application changed over recorded episodes.
Command DriftCommand();

}  // namespace contact_shapelets::cli
