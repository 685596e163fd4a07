#pragma once

#include <string>

#include "contact_shapelets/core/model.h"

/// \file
/// Models as files: a bag with one ShapeletModel message on `model`, so that `rosbag info` describes it.

namespace contact_shapelets {

/// Writes `model` to `path` so that the file is either the old or the new one, whatever happens.
/// \throws std::runtime_error naming the file where it cannot be written.
void SaveModel(const std::string& path, const core::Model& model);

/// Reads a model. \throws std::runtime_error in one line that names the file, what was expected and what was found: no
/// such file, not a bag, no model in it, another version of the message, or faulty contents.
core::Model LoadModel(const std::string& path);

}  // namespace contact_shapelets
