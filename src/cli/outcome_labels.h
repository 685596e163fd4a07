#pragma once

#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

/// \file
/// Outcomes of episodes from a table, for bags that were recorded without them.

namespace contact_shapelets::cli {

/// Sets the outcomes of `episodes` by the table `path`: lines of `episode_id,outcome`, quoted as in RFC 4180, with or
/// without this head line. An outcome of the table replaces the bag's. Ignores empty lines.
/// \throws std::runtime_error in one line that names the file and the line: it cannot be read, a line does not have two
/// columns, or an id is not that of exactly one episode or comes twice.
void SetOutcomes(const std::string& path, std::vector<core::Episode>* episodes);

}  // namespace contact_shapelets::cli
