#if defined(__x86_64__)

#include "core/matching/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops Avx512HalfLoops() { return TileLoops<8, 2>::All("avx512 half"); }

}  // namespace contact_shapelets::core::tile

#endif
