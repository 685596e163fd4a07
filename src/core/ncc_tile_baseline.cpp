#include "core/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops BaselineLoops() {
  // Sixteen registers of four floats hold one vector each of sums and maxima for four shapelets.
  return {"baseline", TileLoops<4, 2>::FullOverlap, TileLoops<4, 1>::PartialOverlaps};
}

}  // namespace contact_shapelets::core::tile
