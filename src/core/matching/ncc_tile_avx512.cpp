#if defined(__x86_64__)

#include "core/matching/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops Avx512Loops() { return TileLoops<16, 2>::All("avx512"); }

}  // namespace contact_shapelets::core::tile

#endif
