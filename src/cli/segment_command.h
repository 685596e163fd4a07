#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `shapelets segment`: the intervals of a recorded wrench between which its shape changes.
Command SegmentCommand();

}  // namespace contact_shapelets::cli
