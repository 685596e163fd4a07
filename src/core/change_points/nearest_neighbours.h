#pragma once

#include <vector>

#include "core/change_points/neighbour_table.h"
#include "core/change_points/subsequences.h"

/// \file
/// Nearest neighbours of the subsequences of a whole series.

namespace contact_shapelets::core {

/// How many samples apart two subsequences of `window` samples must begin to be neighbours: those that share more than
/// half of their samples are alike for no other reason.
inline int ExclusionZone(int window) { return window / 2 + 1; }

/// The `neighbours` nearest of each of the `count` subsequences from `first` on among them, by the Euclidean distance
/// of the z-normalised subsequences, that is, by correlation. Exact up to kTie, except where the series' deviation is a
/// millionth of the largest: there rounding decides. Indices count from `first` on.
///
/// Takes O(count^2) time and O(count neighbours) memory.
NeighbourTable FindNearestNeighbours(const Subsequences& subsequences, int first, int count, int neighbours);

/// Corrects the votes, as of NeighbourTable::Votes(), of the subsequences from `first` on that are flat: as all of
/// these are equally near to one another, all of them are neighbours.
void CorrectVotesOfFlatOnes(const Subsequences& subsequences, int first, std::vector<int>* votes);

}  // namespace contact_shapelets::core
