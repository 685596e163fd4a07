#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `evaluate --data DIR --datasets A,B --methods M,N --seeds 5`: compares methods on data sets with known classes.
Command EvaluateCommand();

}  // namespace contact_shapelets::cli
