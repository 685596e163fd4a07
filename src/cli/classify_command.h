#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `classify BAG... --model M.bag`: diagnoses the episodes of bags.
Command ClassifyCommand();

}  // namespace contact_shapelets::cli
