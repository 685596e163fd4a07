#pragma once

#include <memory>
#include <vector>

#include "core/matching/ncc_definition.h"
#include "core/matching/ncc_windows.h"

/// \file
/// The search for best matches (equations 2 and 3 of the paper) that training and classification use.

namespace contact_shapelets::core {

/// How the transform-free kernel searches.
struct MatchOptions {
  bool prune = true;  ///< skip what the energy bound shows cannot win; the result is the same
};

/// Memory that one search after the other works in. It grows to what the largest of them needed.
class SearchMemory {
 public:
  SearchMemory();
  ~SearchMemory();
  SearchMemory(SearchMemory&&) noexcept;
  SearchMemory& operator=(SearchMemory&&) noexcept;

  struct Arrays;
  /// For FindBestMatches() alone.
  Arrays& arrays() { return *arrays_; }

 private:
  std::unique_ptr<Arrays> arrays_;
};

/// The transform-free kernel: O(Q M) per shapelet before pruning, exact to 1e-5 in single precision.
///
/// `hints` is empty or holds K matches of an earlier, similar search (the previous training step): their similarity is
/// evaluated first, so that the bound prunes from the start. Writes K matches to `matches`, which may be `hints`.
/// Allocates nothing where `memory` and `matches` are large enough from a search before. Several threads may search at
/// the same time, each with a memory and matches of its own.
/// \throws std::invalid_argument where lengths or counts differ.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, SearchMemory* memory, std::vector<Match>* matches);

/// The same in memory of its own.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches);

/// The name of the widest vector instruction set that FindBestMatches uses on this machine, for reports: "avx512",
/// "avx2", ...
const char* KernelInstructionSet();

}  // namespace contact_shapelets::core
