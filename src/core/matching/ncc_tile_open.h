#pragma once

#include "core/matching/ncc_tile.h"

/// \file
/// The search of a tile's open blocks: the blocks of partial overlaps that are not known to be low.

namespace contact_shapelets::core::tile {
namespace {

/// Searches with the loops of `Tile`, a TileLoops.
template <typename Tile>
struct OpenLoops {
  using Range = typename Tile::Range;
  using Useful = typename Tile::Useful;

  /// Shapelets of a group that share a search.
  struct Searched {
    int members[kGroup];
    int count = 0;
    unsigned blocks = 0;     ///< blocks that are open to one of them
    bool from_full = false;  ///< whether sums begin with the full overlaps

    void Add(int member, unsigned open) {
      members[count++] = member;
      blocks |= open;
    }
  };

  /// Tile::AnyBetter() over the open blocks.
  static unsigned AnyBetter(const PartialArguments& arguments, const Searched& searched, const float* least, int tile) {
    const Range range = Tile::OverlapsOf(arguments, searched.blocks);
    const int* members = searched.members;
    const bool from_full = searched.from_full;
    switch (searched.count) {
      case 1:
        return Tile::template AnyBetter<1>(arguments, {{members[0]}}, least, tile, range, from_full);
      case 2:
        return Tile::template AnyBetter<2>(arguments, {{members[0], members[1]}}, least, tile, range, from_full);
    }
    if constexpr (Tile::kTogether == 4) {
      if (searched.count == 3) {
        return Tile::template AnyBetter<3>(arguments, {{members[0], members[1], members[2]}}, least, tile, range,
                                           from_full);
      }
      return Tile::template AnyBetter<4>(arguments, {{members[0], members[1], members[2], members[3]}}, least, tile,
                                         range, from_full);
    }
    return 0;
  }

  /// Returns a bit for each shapelet that exceeds its best. Notes low blocks of the shapelets in `renewed`.
  static unsigned Search(const PartialArguments& arguments, const Searched& searched, int tile) {
    const unsigned lowered = AnyBetter(arguments, searched, arguments.lowered, tile);
    if (arguments.renewed == 0) return lowered;
    const unsigned walked = (2U << (31 - __builtin_clz(searched.blocks))) - (1U << __builtin_ctz(searched.blocks));
    Searched close;
    for (int i = 0; i < searched.count; ++i) {
      const int member = searched.members[i];
      if ((arguments.renewed >> member & 1U) == 0) continue;
      if ((lowered >> member & 1U) != 0) {
        close.Add(member, searched.blocks);
      } else {
        arguments.low[kGroup * tile + member] |= static_cast<BlockBits>(walked);
      }
    }
    close.from_full = searched.from_full;
    const unsigned others = lowered & ~arguments.renewed;
    return close.count == 0 ? others : others | AnyBetter(arguments, close, arguments.best, tile);
  }

  /// Searches the open blocks of the useful shapelets. Sums begin where they would if all blocks were open, so that
  /// they round alike.
  static unsigned SearchUseful(const PartialArguments& arguments, const Useful& useful, int tile,
                               const unsigned* open) {
    unsigned better = 0;
    for (int begin = 0; begin < useful.count; begin += Tile::kTogether) {
      const int end = begin + Tile::kTogether < useful.count ? begin + Tile::kTogether : useful.count;
      Range all = useful.ranges[begin];
      Searched searched;
      for (int i = begin; i < end; ++i) {
        const int member = useful.members[i];
        if (useful.ranges[i].low < all.low) all.low = useful.ranges[i].low;
        if (useful.ranges[i].high > all.high) all.high = useful.ranges[i].high;
        if (open[member] != 0) searched.Add(member, open[member]);
      }
      if (searched.count == 0) continue;
      searched.from_full = Tile::FromFullOverlaps(arguments, tile, all);
      better |= Search(arguments, searched, tile);
    }
    return better;
  }

  /// Returns what TileLoops::FindBetter() returns without low blocks.
  static int FindBetter(const PartialArguments& arguments, int tile, int end, unsigned* better) {
    for (; tile < end; ++tile) {
      const bool has_full = Tile::HasFullOverlaps(arguments, tile);
      unsigned blocks[kGroup] = {};
      for (int i = 0; i < arguments.count; ++i) blocks[i] = Tile::UsefulBlocks(arguments, i, tile, has_full);
      if ((blocks[0] | blocks[1] | blocks[2] | blocks[3]) == 0) continue;
      const BlockBits* low = arguments.low + kGroup * tile;
      unsigned open[kGroup];
      for (int i = 0; i < kGroup; ++i) open[i] = blocks[i] & ~static_cast<unsigned>(low[i]);
      if ((open[0] | open[1] | open[2] | open[3]) == 0) continue;
      Useful useful;
      for (int i = 0; i < arguments.count; ++i) {
        if (blocks[i] != 0) useful.Add(i, Tile::OverlapsOf(arguments, blocks[i]));
      }
      *better = SearchUseful(arguments, useful, tile, open);
      if (*better != 0) break;
    }
    return tile;
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
