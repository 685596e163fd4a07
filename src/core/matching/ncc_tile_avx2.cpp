#if defined(__x86_64__)

#include "core/matching/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops Avx2Loops() { return TileLoops<8, 2>::All("avx2"); }

}  // namespace contact_shapelets::core::tile

#endif
