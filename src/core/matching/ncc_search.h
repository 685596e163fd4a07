#pragma once

#include <vector>

#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_tile.h"

/// \file
/// The transform-free search with its inner loops as an argument, so that one machine can test each instruction set.

namespace contact_shapelets::core {

/// Returns the inner loops that this machine can run, from those that every machine of its architecture can run to the
/// widest.
std::vector<tile::Loops> RunnableLoops();

/// Which partial overlaps a search in single precision leaves out because they cannot win. The result is the same.
/// Windows that need double precision are always pruned by energy.
enum class Pruning {
  kNone,      ///< none
  kByEnergy,  ///< those that the shapelets' energies rule out
  kByBounds,  ///< also those that a table of the windows' energies rules out
};

/// FindBestMatches() with the given loops and pruning.
void FindBestMatchesWith(const tile::Loops& loops, const WindowSet& windows, const ShapeletSet& shapelets,
                         const std::vector<Match>& hints, Pruning pruning, SearchMemory* memory,
                         std::vector<Match>* matches);

}  // namespace contact_shapelets::core
