#if defined(__x86_64__)

#include "core/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops Avx512Loops() { return {"avx512", TileLoops<16, 4>::FullOverlap, TileLoops<16, 2>::PartialOverlaps}; }

}  // namespace contact_shapelets::core::tile

#endif
