#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_low_blocks.h"
#include "core/matching/ncc_search.h"
#include "core/matching/ncc_tile.h"

namespace contact_shapelets::core {
namespace {

/// A search with fewer multiply-adds of full overlaps than this uses vectors of at most 256 bits. A processor that has
/// not used vectors of 512 bits for a while may take some 2 microseconds to run them at full speed, but they save such
/// a small search only a few tenths of a microsecond.
constexpr std::int64_t kSmallSearch = 50000;

/// From this many samples of all shapelets together on, the table of the windows' energies saves more time than it
/// takes to make.
constexpr int kSamplesForBounds = 650;

Pruning BestPruning(const ShapeletSet& shapelets, const MatchOptions& options) {
  if (!options.prune) return Pruning::kNone;
  return shapelets.count() * shapelets.length() < kSamplesForBounds ? Pruning::kByEnergy : Pruning::kByBounds;
}

const tile::Loops& WidestLoops() {
  static const tile::Loops loops = RunnableLoops().back();
  return loops;
}

const tile::Loops& LoopsOfSmallSearches() {
  static const tile::Loops loops = [] {
    std::vector<tile::Loops> runnable = RunnableLoops();
    while (runnable.size() > 1 && runnable.back().vector_bits > 256) runnable.pop_back();
    return runnable.back();
  }();
  return loops;
}

const tile::Loops& BestLoops(const WindowSet& windows, const ShapeletSet& shapelets) {
  std::int64_t multiply_adds = 0;
  for (const WindowStretch& stretch : windows.stretches()) multiply_adds += stretch.count;
  multiply_adds *= static_cast<std::int64_t>(shapelets.length()) * shapelets.count();
  return multiply_adds < kSmallSearch ? LoopsOfSmallSearches() : WidestLoops();
}

}  // namespace

std::vector<tile::Loops> RunnableLoops() {
  std::vector<tile::Loops> loops{tile::BaselineLoops()};
#if defined(__x86_64__)
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2) loops.push_back(tile::Avx2Loops());
  if (avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw")) {
    loops.push_back(tile::Avx512HalfLoops());
    loops.push_back(tile::Avx512Loops());
  }
#endif
  return loops;
}

void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, SearchMemory* memory, std::vector<Match>* matches) {
  FindBestMatchesWith(BestLoops(windows, shapelets), windows, shapelets, hints, BestPruning(shapelets, options), memory,
                      matches);
}

void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches) {
  SearchMemory memory;
  FindBestMatches(windows, shapelets, hints, options, &memory, matches);
}

void FindBestMatchesAgain(const WindowSet& windows, const ShapeletSet& shapelets, const ShapeletHistory& history,
                          LowBlocks* low_blocks, std::vector<Match>* matches) {
  SearchMemory memory;
  FindBestMatchesAgain(BestLoops(windows, shapelets), windows, shapelets, BestPruning(shapelets, MatchOptions{}),
                       history, &memory, low_blocks, matches);
}

const char* KernelInstructionSet() { return WidestLoops().name; }

}  // namespace contact_shapelets::core
