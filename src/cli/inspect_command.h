#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `inspect BAG...`: says what is in bags, what is wrong with it, and what to do about it.
Command InspectCommand();

}  // namespace contact_shapelets::cli
