#include "contact_shapelets/core/ncc.h"
#include "core/ncc_search.h"
#include "core/ncc_tile.h"

namespace contact_shapelets::core {
namespace {

const tile::Loops& BestLoops() {
  static const tile::Loops loops = RunnableLoops().back();
  return loops;
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
    loops.push_back(tile::Avx512Loops());
  }
#endif
  return loops;
}

void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches) {
  FindBestMatchesWith(BestLoops(), windows, shapelets, hints, options, matches);
}

const char* KernelInstructionSet() { return BestLoops().name; }

}  // namespace contact_shapelets::core
