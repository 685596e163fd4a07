#if defined(__x86_64__)

#include "core/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops Avx2Loops() { return {"avx2", TileLoops<8, 2>::FullOverlap, TileLoops<8, 1>::PartialOverlaps}; }

}  // namespace contact_shapelets::core::tile

#endif
