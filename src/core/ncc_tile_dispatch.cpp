#include "contact_shapelets/core/ncc.h"
#include "core/ncc_tile.h"

namespace contact_shapelets::core {
namespace tile {

const Loops& BestLoops() {
  static const Loops loops = [] {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw")) {
      return Avx512Loops();
    }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Avx2Loops();
#endif
    return BaselineLoops();
  }();
  return loops;
}

}  // namespace tile

const char* KernelInstructionSet() { return tile::BestLoops().name; }

}  // namespace contact_shapelets::core
