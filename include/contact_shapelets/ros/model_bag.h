#pragma once

#include <map>
#include <string>

#include "contact_shapelets/core/model.h"

/// \file
/// Models as files: a bag with one ShapeletModel message on `model`, so that `rosbag info` describes it.

namespace contact_shapelets {

/// Writes `model` to `path` so that the file is either the old or the new one, whatever happens. The model's time of
/// training is kept. \throws std::runtime_error naming the file where it cannot be written, or the model is one that
/// LoadModel() would refuse.
void SaveModel(const std::string& path, const core::Model& model);

/// Reads a model. \throws std::runtime_error in one line that names the file, what was expected and what was found: no
/// such file, not a bag, no model in it, another version of the message, or faulty contents.
core::Model LoadModel(const std::string& path);

/// Names clusters (by index) in the model file `path`. Names of other clusters stay, also those that another process
/// puts there at the same time: each waits for the other. Returns what is in the file then. \throws std::runtime_error
/// as LoadModel() and SaveModel() do, and where the file holds another model than `model_id` or lacks a cluster.
core::Model NameClustersInFile(const std::string& path, const std::string& model_id,
                               const std::map<int, std::string>& names);

}  // namespace contact_shapelets
