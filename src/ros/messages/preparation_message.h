#pragma once

#include <contact_shapelets/Preparation.h>

#include "contact_shapelets/core/preparation.h"

namespace contact_shapelets {

/// Returns the message of a preparation.
Preparation ToMessage(const core::Preparation& preparation);

/// Returns the preparation of a message. \throws std::invalid_argument if a word is not one of those in
/// Preparation.msg.
core::Preparation FromMessage(const Preparation& message);

}  // namespace contact_shapelets
