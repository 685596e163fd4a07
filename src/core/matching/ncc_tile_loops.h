#pragma once

#include "core/matching/ncc_tile.h"
#include "core/matching/ncc_tile_full.h"
#include "core/matching/ncc_tile_open.h"
#include "core/matching/ncc_tile_prepare.h"
#include "core/matching/ncc_tile_vector.h"

// Everything is in an unnamed namespace because each instruction set has its own copy.

namespace contact_shapelets::core::tile {
namespace {

/// The loops for vectors of `Lanes` floats. A tile has `Vectors` of them.
template <int Lanes, int Vectors>
struct TileLoops {
  using Of = VectorOf<Lanes>;
  using Vector = typename Of::Floats;
  using Integers = typename Of::Integers;
  static constexpr int kPositions = Lanes * Vectors;
  /// Shapelets that share a pass of partial overlaps: as many as the registers hold.
  static constexpr int kTogether = Of::kManyRegisters ? 4 : 2;
  /// Stands for a full overlap that is not known.
  static constexpr float kUnknown = 1e30F;
  static_assert(2 * kPositions <= kPadding, "tiles reach beyond the padding");

  static Vector Load(const float* from) { return Of::template Load<Vector>(from); }

  /// Overlaps low ... high; none if low > high.
  struct Range {
    int low;
    int high;
  };

  static bool HasFullOverlaps(const PartialArguments& arguments, int tile) {
    return tile >= 0 && tile < arguments.full_tiles && arguments.largest[kGroup * tile] >= 0.0F;
  }

  /// Returns a bit for each block of overlaps of a tile in which a shapelet can exceed its best. A block is left out if
  /// one of two bounds by Cauchy and Schwarz is below the best. Head: the value is at most the root of the shapelet's
  /// times the window's energy within the overlap. Tail: the value differs from the full overlap at the same position,
  /// scaled for the same window, by at most the root of the two energies outside of the overlap.
  static unsigned UsefulBlocks(const PartialArguments& arguments, int shapelet, int tile, bool has_full) {
    const Bounds& bounds = arguments.bounds[tile];
    const Energies& energies = arguments.energies[shapelet];
    const float best = arguments.best[shapelet];
    const float full = has_full ? arguments.largest[kGroup * tile + shapelet] : kUnknown;
    unsigned useless = 0;
    for (int block = 0; block < kBlocks; block += Lanes) {
      const Vector head = Load(energies.head + block) * Load(bounds.head + block) - best * best;
      const Vector rest = best - full * Load(bounds.scale + block);
      const Vector tail = Of::Larger(Load(energies.tail + block) * Load(bounds.tail + block) - rest * rest, -rest);
      // The smaller one is negative if one of the bounds is below the best.
      useless |= Of::Signs((Integers)(head < tail ? head : tail)) << block;
    }
    return ~useless & ((1U << kBlocks) - 1U);
  }

  static Range OverlapsOf(const PartialArguments& arguments, unsigned blocks) {
    const int last = (32 - __builtin_clz(blocks)) * arguments.block;
    return {__builtin_ctz(blocks) * arguments.block + 1, last < arguments.length ? last : arguments.length - 1};
  }

  /// Returns the overlaps that hold so much of a shapelet's energy that it can exceed its best, whatever the window.
  static Range OverlapsByEnergy(const PartialArguments& arguments, int shapelet) {
    if (!arguments.prune) return {1, arguments.length - 1};
    const float least = arguments.best[shapelet] * arguments.best[shapelet];
    int low = arguments.length;
    while (low > 1 && arguments.energy[kGroup * (low - 1) + shapelet] >= least) --low;
    return {low, arguments.length - 1};
  }

  /// Returns the overlaps of `range` at which a position of the tile belongs to a window of the stretch.
  static Range Reaching(const PartialArguments& arguments, int tile, Range range) {
    const int first = tile * kPositions;
    const int last = first + kPositions - 1;
    const bool ahead = arguments.direction > 0;
    const int low = ahead ? arguments.length - last : arguments.length + first - arguments.windows + 1;
    const int high = ahead ? arguments.length - first + arguments.windows - 1 : arguments.length + last;
    return {low > range.low ? low : range.low, high < range.high ? high : range.high};
  }

  /// Some shapelets of a group by their index in it.
  template <int Count>
  struct Members {
    int index[Count];
  };

  /// Sums of `Count` shapelets at an overlap that changes by one sample at a time. Their signs are turned, because the
  /// loops test best M sigma + mu S - A: each step of it is then one instruction.
  template <int Count>
  struct Sums {
    Vector turned[Count][Vectors];

    template <bool Add>
    void Change(const PartialArguments& arguments, const Members<Count>& members, int position, int overlap) {
      const float* values = arguments.values + kGroup * (overlap - 1);
      const float* samples = arguments.samples + position + arguments.direction * (overlap - 1);
      Vector value[Count];
      for (int i = 0; i < Count; ++i) value[i] = Of::Spread(values[members.index[i]]);
      for (int v = 0; v < Vectors; ++v) {
        const Vector sample = Of::LoadOnce(samples + v * Lanes);
        for (int i = 0; i < Count; ++i) {
          turned[i][v] = Add ? turned[i][v] - value[i] * sample : turned[i][v] + value[i] * sample;
        }
      }
    }
  };

  /// Returns true if a walk down from the full overlaps takes fewer steps than a walk up.
  static bool FromFullOverlaps(const PartialArguments& arguments, int tile, Range range) {
    return HasFullOverlaps(arguments, tile) && arguments.length - range.high < range.low;
  }

  /// Calls `evaluate` at every overlap of the range, in the direction that takes fewer steps.
  template <int Count, typename Evaluate>
  static void Walk(const PartialArguments& arguments, const Members<Count>& members, int tile, Range range,
                   Evaluate evaluate) {
    Walk<Count>(arguments, members, tile, range, FromFullOverlaps(arguments, tile, range), evaluate);
  }

  /// The same from the full overlaps down, or from an overlap of one sample up.
  template <int Count, typename Evaluate>
  static void Walk(const PartialArguments& arguments, const Members<Count>& members, int tile, Range range,
                   bool from_full, Evaluate evaluate) {
    const int position = tile * kPositions;
    Sums<Count> sums{};
    if (from_full) {
      for (int i = 0; i < Count; ++i) {
        for (int v = 0; v < Vectors; ++v) {
          sums.turned[i][v] = -Load(arguments.sums + members.index[i] * arguments.stride + position + v * Lanes);
        }
      }
      for (int overlap = arguments.length; overlap > range.high + 1; --overlap) {
        sums.template Change<false>(arguments, members, position, overlap);
      }
      for (int overlap = range.high; overlap >= range.low; --overlap) {
        sums.template Change<false>(arguments, members, position, overlap + 1);
        evaluate(sums, position + arguments.direction * overlap, overlap);
      }
    } else {
      for (int overlap = 1; overlap < range.low; ++overlap) {
        sums.template Change<true>(arguments, members, position, overlap);
      }
      for (int overlap = range.low; overlap <= range.high; ++overlap) {
        sums.template Change<true>(arguments, members, position, overlap);
        evaluate(sums, position + arguments.direction * overlap, overlap);
      }
    }
  }

  /// Returns a bit for each shapelet of the group that exceeds its value in `least`: least M sigma - (A - mu S) is then
  /// negative. An OR collects the signs, so that the units that multiply and add are free for the sums.
  template <int Count>
  static unsigned AnyBetter(const PartialArguments& arguments, const Members<Count>& members, const float* least,
                            int tile, Range range, bool from_full) {
    Integers signs[Count] = {};
    Vector best[Count];
    for (int i = 0; i < Count; ++i) best[i] = Vector{} + least[members.index[i]];
    Walk<Count>(arguments, members, tile, range, from_full, [&](const Sums<Count>& sums, int window, int overlap) {
      const float* of_overlap = arguments.within + kGroup * overlap;
      Vector within[Count];
      for (int i = 0; i < Count; ++i) within[i] = Of::Spread(of_overlap[members.index[i]]);
      for (int v = 0; v < Vectors; ++v) {
        const Vector mean = Of::LoadOnce(arguments.mean + window + v * Lanes);
        const Vector spread = Of::LoadOnce(arguments.spread + window + v * Lanes);
        for (int i = 0; i < Count; ++i) {
          signs[i] |= (Integers)(best[i] * spread + (within[i] * mean + sums.turned[i][v]));
        }
      }
    });
    unsigned better = 0;
    for (int i = 0; i < Count; ++i) better |= (Of::Signs(signs[i]) != 0 ? 1U : 0U) << members.index[i];
    return better;
  }

  /// AnyBetter() for the `Count` shapelets from `member` on, from the least to the greatest overlap of their ranges.
  template <int Count>
  static unsigned AnyOfThese(const PartialArguments& arguments, const int* member, const Range* ranges, int tile) {
    Members<Count> members;
    Range all = ranges[0];
    for (int i = 0; i < Count; ++i) {
      members.index[i] = member[i];
      if (ranges[i].low < all.low) all.low = ranges[i].low;
      if (ranges[i].high > all.high) all.high = ranges[i].high;
    }
    if (arguments.bounds == nullptr) all = Reaching(arguments, tile, all);
    if (all.low > all.high) return 0;
    return AnyBetter<Count>(arguments, members, arguments.best, tile, all, FromFullOverlaps(arguments, tile, all));
  }

  /// The shapelets of a group that can exceed their best in a tile, by their index in it, and their overlaps.
  struct Useful {
    int members[kGroup];
    Range ranges[kGroup];
    int count = 0;

    void Add(int member, Range range) {
      members[count] = member;
      ranges[count++] = range;
    }
  };

  static unsigned AnyOfUseful(const PartialArguments& arguments, const Useful& useful, int tile) {
    unsigned better = 0;
    int done = 0;
    if (kTogether >= 4 && useful.count == 4) {
      better = AnyOfThese<4>(arguments, useful.members, useful.ranges, tile);
      done = 4;
    } else if (kTogether >= 3 && useful.count == 3) {
      better = AnyOfThese<3>(arguments, useful.members, useful.ranges, tile);
      done = 3;
    }
    for (; done + 2 <= useful.count; done += 2) {
      better |= AnyOfThese<2>(arguments, useful.members + done, useful.ranges + done, tile);
    }
    if (done < useful.count) better |= AnyOfThese<1>(arguments, useful.members + done, useful.ranges + done, tile);
    return better;
  }

  /// FindBetter() if the shapelets' energies alone prune: all tiles have the same useful shapelets and overlaps.
  static int FindBetterByEnergy(const PartialArguments& arguments, int tile, int end, unsigned* better) {
    Useful useful;
    for (int i = 0; i < arguments.count; ++i) {
      const Range range = OverlapsByEnergy(arguments, i);
      if (range.low <= range.high) useful.Add(i, range);
    }
    if (useful.count == 0) return end;
    for (; tile < end; ++tile) {
      *better = AnyOfUseful(arguments, useful, tile);
      if (*better != 0) break;
    }
    return tile;
  }

  static int FindBetter(const PartialArguments& arguments, int tile, int end, unsigned* better) {
    if (arguments.bounds == nullptr) return FindBetterByEnergy(arguments, tile, end, better);
    if (arguments.low != nullptr) return OpenLoops<TileLoops>::FindBetter(arguments, tile, end, better);
    for (; tile < end; ++tile) {
      const bool has_full = HasFullOverlaps(arguments, tile);
      unsigned blocks[kGroup] = {};
      for (int i = 0; i < arguments.count; ++i) blocks[i] = UsefulBlocks(arguments, i, tile, has_full);
      if ((blocks[0] | blocks[1] | blocks[2] | blocks[3]) == 0) continue;
      Useful useful;
      for (int i = 0; i < arguments.count; ++i) {
        if (blocks[i] != 0) useful.Add(i, OverlapsOf(arguments, blocks[i]));
      }
      *better = AnyOfUseful(arguments, useful, tile);
      if (*better != 0) break;
    }
    return tile;
  }

  static void MostInTile(const PartialArguments& arguments, int shapelet, int tile, TileResult* result) {
    Vector most[Vectors] = {};
    Integers at[Vectors] = {};
    const Range range =
        arguments.bounds == nullptr
            ? Reaching(arguments, tile, OverlapsByEnergy(arguments, shapelet))
            : OverlapsOf(arguments, UsefulBlocks(arguments, shapelet, tile, HasFullOverlaps(arguments, tile)));
    Walk<1>(arguments, {{shapelet}}, tile, range, [&](const Sums<1>& sums, int window, int overlap) {
      const float within = arguments.within[kGroup * overlap + shapelet];
      for (int v = 0; v < Vectors; ++v) {
        const Vector mean = Load(arguments.mean + window + v * Lanes);
        const Vector scale = Load(arguments.scale + window + v * Lanes);
        const Vector value = -(within * mean + sums.turned[0][v]) * scale;
        const Integers greater = value > most[v];
        most[v] = greater ? value : most[v];
        at[v] = greater ? Integers{} + overlap : at[v];
      }
    });
    Vector largest = most[0];
    for (int v = 1; v < Vectors; ++v) largest = Of::Larger(largest, most[v]);
    *result = {Of::Largest(largest), 0, 0};
    for (int v = Vectors - 1; v >= 0; --v) {
      const unsigned lanes = Of::Signs(most[v] == result->value);
      if (lanes == 0) continue;
      const int lane = __builtin_ctz(lanes);
      int overlaps[Lanes];
      Of::Store(overlaps, at[v]);
      result->position = tile * kPositions + v * Lanes + lane;
      result->overlap = overlaps[lane];
    }
  }

  /// Returns CC_w M sigma of one window by the definition.
  static double Correlation(const float* shapelet, const float* samples, double mean, int count) {
    typename Of::Doubles sum = {};
    int m = 0;
    for (; m + Lanes / 2 <= count; m += Lanes / 2) {
      sum += Of::LoadDoubles(shapelet + m) * (Of::LoadDoubles(samples + m) - mean);
    }
    double parts[Lanes / 2];
    Of::Store(parts, sum);
    for (int half = Lanes / 4; half > 0; half /= 2) {
      for (int part = 0; part < half; ++part) parts[part] += parts[part + half];
    }
    double total = parts[0];
    for (; m < count; ++m) total += static_cast<double>(shapelet[m]) * (static_cast<double>(samples[m]) - mean);
    return total;
  }

  static Loops All(const char* name) {
    using Full = FullLoops<Lanes, Vectors>;
    using Prepare = PreparationLoops<Lanes, Vectors>;
    return {name,
            kPositions,
            32 * Lanes,
            Full::FullOverlaps,
            FindBetter,
            MostInTile,
            Correlation,
            Prepare::WindowValues,
            Prepare::AllBounds};
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
