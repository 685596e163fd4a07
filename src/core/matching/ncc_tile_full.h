#pragma once

#include "core/matching/ncc_tile.h"
#include "core/matching/ncc_tile_vector.h"

/// \file
/// The loops that compute full overlaps.

namespace contact_shapelets::core::tile {
namespace {

template <int Lanes, int Vectors>
struct FullLoops {
  using Of = VectorOf<Lanes>;
  using Vector = typename Of::Floats;
  using Integers = typename Of::Integers;
  static constexpr int kPositions = Lanes * Vectors;
  /// Tiles that share a pass: as many as the registers hold.
  static constexpr int kFullTiles = Of::kManyRegisters ? 2 : 1;

  static Vector Load(const float* from) { return Of::template Load<Vector>(from); }

  static bool AnyCounts(const float* scale) {
    Vector largest = Load(scale);
    for (int v = 1; v < Vectors; ++v) largest = Of::Larger(largest, Load(scale + v * Lanes));
    return Of::Signs(largest > 0.0F) != 0;
  }

  /// The largest full overlaps of a group so far, lane by lane.
  struct Most {
    Vector value[kGroup];
    Integers position[kGroup];
  };

  /// Computes the full overlaps of `Tiles` tiles from `position` on. Each tile must hold a window that counts.
  template <int Tiles>
  static void FullTiles(const FullArguments& arguments, int position, Most* most) {
    constexpr int kVectors = Tiles * Vectors;
    Vector sum[kGroup][kVectors] = {};
    for (int m = 0; m < arguments.length; ++m) {
      Vector values[kGroup];
      for (int i = 0; i < kGroup; ++i) values[i] = Of::Spread(arguments.shapelets[kGroup * m + i]);
#pragma GCC unroll 4
      for (int v = 0; v < kVectors; ++v) {
        const Vector samples = Of::LoadOnce(arguments.series + position + m + v * Lanes);
        for (int i = 0; i < kGroup; ++i) sum[i][v] += values[i] * samples;
      }
    }
#pragma GCC unroll 4
    for (int v = 0; v < kVectors; ++v) {
      const Vector scale = Load(arguments.scale + position + v * Lanes);
      for (int i = 0; i < kGroup; ++i) {
        Of::Store(arguments.sums + i * arguments.stride + position + v * Lanes, sum[i][v]);
        const Vector value = sum[i][v] * scale;
        const Integers greater = value > most->value[i];
        most->value[i] = greater ? value : most->value[i];
        most->position[i] = greater ? Integers{} + (position + v * Lanes) : most->position[i];
      }
    }
    for (int tile = 0; tile < Tiles; ++tile) {
      arguments.largest[(position / kPositions + tile) * kGroup] = 0.0F;
      for (int i = 0; arguments.with_largest && i < kGroup; ++i) {
        Vector largest = sum[i][tile * Vectors];
        for (int v = 1; v < Vectors; ++v) largest = Of::Larger(largest, sum[i][tile * Vectors + v]);
        const float value = Of::Largest(largest);
        arguments.largest[(position / kPositions + tile) * kGroup + i] = value > 0.0F ? value : 0.0F;
      }
    }
  }

  static void FullOverlaps(const FullArguments& arguments, FullResult* result) {
    Most most;
    for (int i = 0; i < kGroup; ++i) most.value[i] = Vector{}, most.position[i] = Integers{};
    for (int position = 0; position < arguments.count; position += kPositions) {
      if (!AnyCounts(arguments.scale + position)) {
        arguments.largest[position / kPositions * kGroup] = -1.0F;
        continue;
      }
      const int next = position + kPositions;
      if (kFullTiles == 2 && next < arguments.count && AnyCounts(arguments.scale + next)) {
        FullTiles<kFullTiles>(arguments, position, &most);
        position = next;
      } else {
        FullTiles<1>(arguments, position, &most);
      }
    }
    for (int i = 0; i < kGroup; ++i) {
      result->most[i] = Of::Largest(most.value[i]);
      result->position[i] = -1;
      if (result->most[i] <= 0.0F) continue;
      const int lane = __builtin_ctz(Of::Signs(most.value[i] == result->most[i]));
      int positions[Lanes];
      Of::Store(positions, most.position[i]);
      result->position[i] = positions[lane] + lane;
    }
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
