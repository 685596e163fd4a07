#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `inspect BAG...`: shows the contents of bags and models, what is wrong with them, and what to do.
Command InspectCommand();

}  // namespace contact_shapelets::cli
