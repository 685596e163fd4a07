#include "core/matching/ncc_tile_loops.h"

namespace contact_shapelets::core::tile {

Loops BaselineLoops() { return TileLoops<4, 2>::All("baseline"); }

}  // namespace contact_shapelets::core::tile
