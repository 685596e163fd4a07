#pragma once

#include "core/ncc_tile.h"
#include "core/ncc_tile_prepare.h"
#include "core/ncc_tile_vector.h"

// Everything is in an unnamed namespace, since each instruction set has a copy of its own.

namespace contact_shapelets::core::tile {
namespace {

/// `Lanes` floats that one instruction works on, and vectors of them per shapelet in registers.
template <int Lanes, int Vectors>
struct TileLoops {
  using Of = VectorOf<Lanes>;
  using Vector = typename Of::Floats;
  using Integers = typename Of::Integers;
  static constexpr int kPositions = Lanes * Vectors;
  /// A full overlap that may be anything.
  static constexpr float kUnknown = 1e30F;
  static_assert(kPositions <= kPadding, "tiles reach beyond the padding");

  static Vector Load(const float* from) { return Of::template Load<Vector>(from); }

  static bool AnyCounts(const float* scale) {
    Vector largest = Load(scale);
    for (int v = 1; v < Vectors; ++v) largest = Of::Larger(largest, Load(scale + v * Lanes));
    return Of::Signs(largest > 0.0F) != 0;
  }

  static void FullOverlaps(const FullArguments& arguments, FullResult* result) {
    Vector most[kGroup] = {};
    Integers at[kGroup];
    for (Integers& where : at) where = Integers{} - 1;
    int numbers[Lanes];
    for (int lane = 0; lane < Lanes; ++lane) numbers[lane] = lane;
    const Integers lanes = Of::template Load<Integers>(numbers);
    for (int position = 0; position < arguments.count; position += kPositions) {
      if (!AnyCounts(arguments.scale + position)) {
        for (int i = 0; i < kGroup; ++i) arguments.largest[position / kPositions * kGroup + i] = -1.0F;
        continue;
      }
      Vector sum[kGroup][Vectors] = {};
      for (int m = 0; m < arguments.length; ++m) {
        Vector values[kGroup];
        for (int i = 0; i < kGroup; ++i) values[i] = Of::Spread(arguments.shapelets[kGroup * m + i]);
        for (int v = 0; v < Vectors; ++v) {
          const Vector samples = Of::LoadOnce(arguments.series + position + m + v * Lanes);
          for (int i = 0; i < kGroup; ++i) sum[i][v] += values[i] * samples;
        }
      }
      for (int v = 0; v < Vectors; ++v) {
        const Vector scale = Load(arguments.scale + position + v * Lanes);
        for (int i = 0; i < kGroup; ++i) {
          Of::Store(arguments.sums + i * arguments.stride + position + v * Lanes, sum[i][v]);
          const Vector value = sum[i][v] * scale;
          const Integers greater = value > most[i];
          most[i] = greater ? value : most[i];
          at[i] = greater ? lanes + (position + v * Lanes) : at[i];
        }
      }
      for (int i = 0; i < kGroup; ++i) {
        Vector largest = sum[i][0];
        for (int v = 1; v < Vectors; ++v) largest = Of::Larger(largest, sum[i][v]);
        const float most_in_tile = Of::Largest(largest);
        arguments.largest[position / kPositions * kGroup + i] = most_in_tile > 0.0F ? most_in_tile : 0.0F;
      }
    }
    for (int i = 0; i < kGroup; ++i) {
      result->most[i] = 0.0F;
      result->position[i] = -1;
      float values[Lanes];
      int positions[Lanes];
      Of::Store(values, most[i]);
      Of::Store(positions, at[i]);
      for (int lane = 0; lane < Lanes; ++lane) {
        if (values[lane] <= result->most[i]) continue;
        result->most[i] = values[lane];
        result->position[i] = positions[lane];
      }
    }
  }

  /// Overlaps low ... high; none where low > high.
  struct Range {
    int low;
    int high;
  };

  static bool HasFullOverlaps(const PartialArguments& arguments, int tile) {
    return tile >= 0 && tile < arguments.full_tiles && arguments.largest[kGroup * tile] >= 0.0F;
  }

  /// The overlaps of a tile at which a shapelet of the pair can exceed its best. By Cauchy and Schwarz, the value is at
  /// most the root of the energies of both within the overlap; and it differs from the full overlap at the same
  /// position, measured by the same window, at most by the root of the energies of both without.
  static Range UsefulOverlaps(const PartialArguments& arguments, int shapelet, int tile) {
    const Bounds& bounds = arguments.bounds[tile];
    const Energies& energies = arguments.energies[shapelet];
    const float best = arguments.best[shapelet];
    const bool has_full = HasFullOverlaps(arguments, tile);
    const float full = has_full ? arguments.largest[kGroup * tile + shapelet] : kUnknown;
    unsigned bits = 0;
    for (int block = 0; block < kBlocks; block += Lanes) {
      const Vector rest = best - full * Load(bounds.scale + block);
      const Integers near = (rest <= 0.0F) | (Load(energies.tail + block) * Load(bounds.tail + block) > rest * rest);
      const Integers strong = Load(energies.head + block) * Load(bounds.head + block) > Vector{} + best * best;
      bits |= Of::Signs(near & strong) << block;
    }
    if (bits == 0) return {1, 0};
    const int low = __builtin_ctz(bits);
    const int high = 31 - __builtin_clz(bits);
    const int last = (high + 1) * arguments.block;
    return {low * arguments.block + 1, last < arguments.length ? last : arguments.length - 1};
  }

  /// Sums of `Shapelets` shapelets at an overlap that changes by one sample at a time. They are kept with their sign
  /// turned: what is tested is best M sigma + mu S - A, and each of its steps is then one instruction.
  template <int Shapelets>
  struct Sums {
    Vector turned[Shapelets][Vectors];

    void Add(const PartialArguments& arguments, int shapelet, int position, int overlap) {
      const float* values = arguments.values + kGroup * (overlap - 1) + shapelet;
      const float* samples = arguments.samples + position + arguments.direction * (overlap - 1);
      Vector value[Shapelets];
      for (int i = 0; i < Shapelets; ++i) value[i] = Of::Spread(values[i]);
      for (int v = 0; v < Vectors; ++v) {
        const Vector sample = Of::LoadOnce(samples + v * Lanes);
        for (int i = 0; i < Shapelets; ++i) turned[i][v] -= value[i] * sample;
      }
    }
    void Remove(const PartialArguments& arguments, int shapelet, int position, int overlap) {
      const float* values = arguments.values + kGroup * (overlap - 1) + shapelet;
      const float* samples = arguments.samples + position + arguments.direction * (overlap - 1);
      Vector value[Shapelets];
      for (int i = 0; i < Shapelets; ++i) value[i] = Of::Spread(values[i]);
      for (int v = 0; v < Vectors; ++v) {
        const Vector sample = Of::LoadOnce(samples + v * Lanes);
        for (int i = 0; i < Shapelets; ++i) turned[i][v] += value[i] * sample;
      }
    }
  };

  /// Calls `evaluate` at every overlap of the range, in the direction that takes fewer steps to reach it.
  template <int Shapelets, typename Evaluate>
  static void Walk(const PartialArguments& arguments, int shapelet, int tile, Range range, Evaluate evaluate) {
    const int position = tile * kPositions;
    Sums<Shapelets> sums{};
    if (HasFullOverlaps(arguments, tile) && arguments.length - range.high < range.low) {
      for (int i = 0; i < Shapelets; ++i) {
        for (int v = 0; v < Vectors; ++v) {
          sums.turned[i][v] = -Load(arguments.sums + (shapelet + i) * arguments.stride + position + v * Lanes);
        }
      }
      for (int overlap = arguments.length; overlap > range.high + 1; --overlap) {
        sums.Remove(arguments, shapelet, position, overlap);
      }
      for (int overlap = range.high; overlap >= range.low; --overlap) {
        sums.Remove(arguments, shapelet, position, overlap + 1);
        evaluate(sums, position + arguments.direction * overlap, overlap);
      }
    } else {
      for (int overlap = 1; overlap < range.low; ++overlap) sums.Add(arguments, shapelet, position, overlap);
      for (int overlap = range.low; overlap <= range.high; ++overlap) {
        sums.Add(arguments, shapelet, position, overlap);
        evaluate(sums, position + arguments.direction * overlap, overlap);
      }
    }
  }

  /// The sign of best M sigma - (A - mu S) tells whether the value exceeds the best: signs are collected by an OR,
  /// which leaves the units that multiply and add to the sums.
  template <int Shapelets>
  static bool AnyBetter(const PartialArguments& arguments, int shapelet, int tile, Range range) {
    Integers signs = {};
    Vector best[Shapelets];
    for (int i = 0; i < Shapelets; ++i) best[i] = Vector{} + arguments.best[shapelet + i];
    Walk<Shapelets>(arguments, shapelet, tile, range, [&](const Sums<Shapelets>& sums, int window, int overlap) {
      Vector within[Shapelets];
      for (int i = 0; i < Shapelets; ++i) within[i] = Of::Spread(arguments.within[kGroup * overlap + shapelet + i]);
      for (int v = 0; v < Vectors; ++v) {
        const Vector mean = Of::LoadOnce(arguments.mean + window + v * Lanes);
        const Vector spread = Of::LoadOnce(arguments.spread + window + v * Lanes);
        for (int i = 0; i < Shapelets; ++i) {
          signs |= (Integers)(best[i] * spread + (within[i] * mean + sums.turned[i][v]));
        }
      }
    });
    return Of::Signs(signs) != 0;
  }

  static int FindBetter(const PartialArguments& arguments, int tile, int end) {
    for (; tile < end; ++tile) {
      const Range first = UsefulOverlaps(arguments, 0, tile);
      const Range second = UsefulOverlaps(arguments, 1, tile);
      const bool one = first.low <= first.high;
      const bool other = second.low <= second.high;
      if (one && other) {
        const Range both{first.low < second.low ? first.low : second.low,
                         first.high > second.high ? first.high : second.high};
        if (AnyBetter<2>(arguments, 0, tile, both)) break;
      } else if (one) {
        if (AnyBetter<1>(arguments, 0, tile, first)) break;
      } else if (other) {
        if (AnyBetter<1>(arguments, 1, tile, second)) break;
      }
    }
    return tile;
  }

  static void MostInTile(const PartialArguments& arguments, int shapelet, int tile, TileResult* result) {
    Vector most[Vectors] = {};
    Integers at[Vectors] = {};
    const Range range = UsefulOverlaps(arguments, shapelet, tile);
    Walk<1>(arguments, shapelet, tile, range, [&](const Sums<1>& sums, int window, int overlap) {
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
    *result = {0.0F, 0, 0};
    float values[kPositions];
    int overlaps[kPositions];
    for (int v = 0; v < Vectors; ++v) {
      Of::Store(values + v * Lanes, most[v]);
      Of::Store(overlaps + v * Lanes, at[v]);
    }
    for (int position = 0; position < kPositions; ++position) {
      if (values[position] <= result->value) continue;
      *result = {values[position], tile * kPositions + position, overlaps[position]};
    }
  }

  /// CC_w M sigma of one window, by the definition.
  static double Correlation(const float* shapelet, const float* samples, double mean, int count) {
    typename Of::Doubles sum = {};
    int m = 0;
    for (; m + Lanes / 2 <= count; m += Lanes / 2) {
      sum += Of::LoadDoubles(shapelet + m) * (Of::LoadDoubles(samples + m) - mean);
    }
    double parts[Lanes / 2];
    Of::Store(parts, sum);
    double total = 0.0;
    for (const double part : parts) total += part;
    for (; m < count; ++m) total += static_cast<double>(shapelet[m]) * (static_cast<double>(samples[m]) - mean);
    return total;
  }

  static Loops All(const char* name) {
    using Prepare = PreparationLoops<Lanes, Vectors>;
    return {name,       kPositions,  FullOverlaps,          FindBetter,
            MostInTile, Correlation, Prepare::WindowValues, Prepare::AllBounds};
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
