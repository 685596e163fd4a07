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
  bool prune = true;  ///< skip overlaps that cannot win by the energy bounds; the result is the same
};

/// Working memory of searches. It grows to what the largest search needs, and keeps that size.
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
/// `hints` is empty or holds the K matches of an earlier, similar search, such as the previous training step. The
/// kernel evaluates them first, so that its bounds prune from the start. Writes K matches to `matches`, which may be
/// `hints`. Allocates nothing if `memory` and `matches` are large enough from an earlier search. Several threads may
/// search at the same time, each with its own memory and matches. \throws std::invalid_argument if lengths or counts
/// differ.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, SearchMemory* memory, std::vector<Match>* matches);

/// The same with its own memory.
void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches);

/// Returns the name of the widest vector instruction set that FindBestMatches() uses on this machine: "avx512", "avx2",
/// ... For reports.
const char* KernelInstructionSet();

}  // namespace contact_shapelets::core
