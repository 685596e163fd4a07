#pragma once

#include <vector>

#include "contact_shapelets/core/ncc.h"
#include "core/ncc_tile.h"

/// \file
/// The transform-free search with its inner loops as an argument, so that each instruction set can be tested on one
/// machine.

namespace contact_shapelets::core {

/// The inner loops that this machine can run, from what every machine of its architecture runs to the widest.
std::vector<tile::Loops> RunnableLoops();

/// FindBestMatches() with the given loops.
void FindBestMatchesWith(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                         const std::vector<Match>& hints, const MatchOptions& options, SearchMemory* memory,
                         std::vector<Match>* matches);

}  // namespace contact_shapelets::core
