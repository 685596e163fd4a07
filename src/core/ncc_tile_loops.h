#pragma once

#include "core/ncc_tile.h"

// Everything is in an unnamed namespace, since each instruction set has a copy of its own.

namespace contact_shapelets::core::tile {
namespace {

/// `Lanes` floats that one instruction works on, and vectors of them per shapelet in registers.
template <int Lanes, int FullVectors, int Vectors>
struct TileLoops {
  typedef float Vector __attribute__((vector_size(Lanes * sizeof(float))));
  typedef int Integers __attribute__((vector_size(Lanes * sizeof(int))));
  typedef double Doubles __attribute__((vector_size(Lanes * sizeof(float))));
  static constexpr int kPositions = Lanes * Vectors;
  static_assert(kPositions <= kPadding && Lanes * FullVectors <= kPadding, "tiles reach beyond the padding");

  template <typename Type>
  static Type Load(const void* from) {
    Type vector;
    __builtin_memcpy(&vector, from, sizeof(vector));
    return vector;
  }
  static Vector Load(const float* from) { return Load<Vector>(from); }
  template <typename Type>
  static void Store(void* to, Type vector) {
    __builtin_memcpy(to, &vector, sizeof(vector));
  }

  static void FullOverlaps(const FullArguments& arguments, FullResult* result) {
    Vector most[kGroup] = {};
    Integers at[kGroup];
    for (Integers& where : at) where = Integers{} - 1;
    int numbers[Lanes];
    for (int lane = 0; lane < Lanes; ++lane) numbers[lane] = lane;
    const Integers lanes = Load<Integers>(numbers);
    for (int position = 0; position < arguments.count; position += Lanes * FullVectors) {
      Vector sum[kGroup][FullVectors] = {};
      for (int m = 0; m < arguments.length; ++m) {
        const float* values = arguments.shapelets + kGroup * m;
        for (int v = 0; v < FullVectors; ++v) {
          const Vector samples = Load(arguments.series + position + m + v * Lanes);
          for (int i = 0; i < kGroup; ++i) sum[i][v] += values[i] * samples;
        }
      }
      for (int v = 0; v < FullVectors; ++v) {
        const Vector scale = Load(arguments.scale + position + v * Lanes);
        for (int i = 0; i < kGroup; ++i) {
          Store(arguments.sums + i * arguments.stride + position + v * Lanes, sum[i][v]);
          const Vector value = sum[i][v] * scale;
          const Integers greater = value > most[i];
          most[i] = greater ? value : most[i];
          at[i] = greater ? lanes + (position + v * Lanes) : at[i];
        }
      }
    }
    for (int i = 0; i < kGroup; ++i) {
      result->most[i] = 0.0F;
      result->position[i] = -1;
      float values[Lanes];
      int positions[Lanes];
      Store(values, most[i]);
      Store(positions, at[i]);
      for (int lane = 0; lane < Lanes; ++lane) {
        if (values[lane] <= result->most[i]) continue;
        result->most[i] = values[lane];
        result->position[i] = positions[lane];
      }
    }
  }

  /// The overlaps of a tile that can exceed what is known, by Cauchy and Schwarz; low > high where none can.
  struct Range {
    int low;
    int high;
  };
  static Range UsefulOverlaps(const PartialArguments& arguments, int tile) {
    const float* bounds = arguments.bounds + tile * arguments.blocks;
    const float first = arguments.best[0] * arguments.best[0];
    const float second = arguments.best[1] * arguments.best[1];
    const auto useful = [&](int block) {
      const float* energy = arguments.energy + kGroup * block;
      return (energy[0] * bounds[block] > first) | (energy[1] * bounds[block] > second);
    };
    int high = arguments.blocks - 1;
    while (high >= 0 && !useful(high)) --high;
    int low = 0;
    while (low < high && !useful(low)) ++low;
    const int last = (high + 1) * arguments.block;
    return {low * arguments.block + 1, last < arguments.length ? last : arguments.length - 1};
  }

  /// Sums of `Shapelets` shapelets at an overlap that changes by one sample at a time.
  template <int Shapelets>
  struct Sums {
    Vector sum[Shapelets][Vectors];

    void Add(const PartialArguments& arguments, int shapelet, int position, int overlap) {
      const float* values = arguments.values + kGroup * (overlap - 1) + shapelet;
      const float* samples = arguments.samples + position + arguments.direction * (overlap - 1);
      for (int v = 0; v < Vectors; ++v) {
        const Vector sample = Load(samples + v * Lanes);
        for (int i = 0; i < Shapelets; ++i) sum[i][v] += values[i] * sample;
      }
    }
    void Remove(const PartialArguments& arguments, int shapelet, int position, int overlap) {
      const float* values = arguments.values + kGroup * (overlap - 1) + shapelet;
      const float* samples = arguments.samples + position + arguments.direction * (overlap - 1);
      for (int v = 0; v < Vectors; ++v) {
        const Vector sample = Load(samples + v * Lanes);
        for (int i = 0; i < Shapelets; ++i) sum[i][v] -= values[i] * sample;
      }
    }
  };

  /// Calls `evaluate` at every overlap of the range, in the direction that takes fewer steps to reach it.
  template <int Shapelets, typename Evaluate>
  static void Walk(const PartialArguments& arguments, int shapelet, int tile, Range range, Evaluate evaluate) {
    const int position = tile * kPositions;
    const bool has_sums = tile >= 0 && tile < arguments.full_tiles;
    Sums<Shapelets> sums{};
    if (has_sums && arguments.length - range.high < range.low) {
      for (int i = 0; i < Shapelets; ++i) {
        for (int v = 0; v < Vectors; ++v) {
          sums.sum[i][v] = Load(arguments.sums + (shapelet + i) * arguments.stride + position + v * Lanes);
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

  /// The sign of best M sigma - (A - mu S) tells whether the value exceeds the best: signs are collected by an OR, which
  /// leaves the units that multiply and add to the sums.
  static bool AnyBetter(const PartialArguments& arguments, int tile, Range range) {
    Integers signs = {};
    Vector best[kPair];
    for (int i = 0; i < kPair; ++i) best[i] = Vector{} + arguments.best[i];
    Walk<kPair>(arguments, 0, tile, range, [&](const Sums<kPair>& sums, int window, int overlap) {
      const float* within = arguments.within + kGroup * overlap;
      for (int v = 0; v < Vectors; ++v) {
        const Vector mean = Load(arguments.mean + window + v * Lanes);
        const Vector spread = Load(arguments.spread + window + v * Lanes);
        for (int i = 0; i < kPair; ++i) {
          signs |= (Integers)(best[i] * spread - (sums.sum[i][v] - within[i] * mean));
        }
      }
    });
    unsigned long long bits[Lanes / 2];
    Store(bits, signs);
    unsigned long long any = 0;
    for (const unsigned long long part : bits) any |= part;
    return (any & 0x8000000080000000ULL) != 0;
  }

  static int FindBetter(const PartialArguments& arguments, int tile, int end) {
    for (; tile < end; ++tile) {
      const Range range = UsefulOverlaps(arguments, tile);
      if (range.low <= range.high && AnyBetter(arguments, tile, range)) break;
    }
    return tile;
  }

  static void MostInTile(const PartialArguments& arguments, int shapelet, int tile, TileResult* result) {
    Vector most[Vectors] = {};
    Integers at[Vectors] = {};
    const Range range = UsefulOverlaps(arguments, tile);
    Walk<1>(arguments, shapelet, tile, range, [&](const Sums<1>& sums, int window, int overlap) {
      const float within = arguments.within[kGroup * overlap + shapelet];
      for (int v = 0; v < Vectors; ++v) {
        const Vector mean = Load(arguments.mean + window + v * Lanes);
        const Vector scale = Load(arguments.scale + window + v * Lanes);
        const Vector value = (sums.sum[0][v] - within * mean) * scale;
        const Integers greater = value > most[v];
        most[v] = greater ? value : most[v];
        at[v] = greater ? Integers{} + overlap : at[v];
      }
    });
    *result = {0.0F, 0, 0};
    float values[kPositions];
    int overlaps[kPositions];
    for (int v = 0; v < Vectors; ++v) {
      Store(values + v * Lanes, most[v]);
      Store(overlaps + v * Lanes, at[v]);
    }
    for (int position = 0; position < kPositions; ++position) {
      if (values[position] <= result->value) continue;
      *result = {values[position], tile * kPositions + position, overlaps[position]};
    }
  }

  static void WindowEnergies(const EnergyArguments& arguments, float* energies) {
    const double* sums = arguments.sums + arguments.first;
    const double* squares = arguments.squares + arguments.first;
    constexpr int kHalf = Lanes / 2;
    for (int window = 0; window < arguments.count; window += kHalf) {
      const Doubles mean = Load<Doubles>(arguments.mean + window);
      const Doubles sum = Load<Doubles>(sums + window + arguments.overlap) - Load<Doubles>(sums + window);
      const Doubles square = Load<Doubles>(squares + window + arguments.overlap) - Load<Doubles>(squares + window);
      const Doubles energy = (square - mean * (2.0 * sum - static_cast<double>(arguments.overlap) * mean)) *
                             Load<Doubles>(arguments.scale + window);
      double values[kHalf];
      Store(values, energy);
      for (int lane = 0; lane < kHalf; ++lane) energies[window + lane] = static_cast<float>(values[lane]);
    }
  }

  static Loops All(const char* name) {
    return {name, kPositions, FullOverlaps, FindBetter, MostInTile, WindowEnergies};
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
