#pragma once

#include <map>
#include <string>

#include "contact_shapelets/core/model.h"

/// \file
/// Models as files. A file is a bag with one ShapeletModel message on the topic `model`, so `rosbag info` describes it.

namespace contact_shapelets {

/// Writes `model` to `path`. If the writing fails, the old file stays whole. \throws std::runtime_error naming the file
/// if it cannot be written or if LoadModel() would refuse the model.
void SaveModel(const std::string& path, const core::Model& model);

/// Reads a model. \throws std::runtime_error in one line with the file, what was expected and what was found: no such
/// file, not a bag, no model in it, another version of the message, or an invalid model.
core::Model LoadModel(const std::string& path);

/// Gives clusters of the model file `path` the `names`, by index. Other clusters keep their names. Processes that call
/// this at the same time wait for each other, so no name is lost. Returns the model that is in the file afterwards.
/// \throws std::runtime_error as LoadModel() and SaveModel() do, and if the file holds another model than `model_id` or
/// lacks a cluster.
core::Model NameClustersInFile(const std::string& path, const std::string& model_id,
                               const std::map<int, std::string>& names);

}  // namespace contact_shapelets
