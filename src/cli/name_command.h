#pragma once

#include "cli/command.h"

namespace contact_shapelets::cli {

/// `name MODEL.bag [2=broken ...]`: names the clusters of a model, and lists them.
Command NameCommand();

}  // namespace contact_shapelets::cli
