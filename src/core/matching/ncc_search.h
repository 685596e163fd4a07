#pragma once

#include <vector>

#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_tile.h"

/// \file
/// The transform-free search with its inner loops as an argument, so that each instruction set can be tested on one
/// machine.

namespace contact_shapelets::core {

/// The inner loops that this machine can run, from what every machine of its architecture runs to the widest.
std::vector<tile::Loops> RunnableLoops();

/// What a search leaves out of the partial overlaps in single precision (windows that need double precision are always
/// pruned by energy). The result is the same.
enum class Pruning {
  kNone,
  kByEnergy,  ///< what the shapelets' energies alone show that cannot win
  kByBounds,  ///< what a table of the windows' energies shows, too
};

/// FindBestMatches() with the given loops and pruning.
void FindBestMatchesWith(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                         const std::vector<Match>& hints, Pruning pruning, SearchMemory* memory,
                         std::vector<Match>* matches);

}  // namespace contact_shapelets::core
