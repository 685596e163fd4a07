#pragma once

#include "core/ncc_tile.h"

// Everything is in an unnamed namespace, since each instruction set has a copy of its own.

namespace contact_shapelets::core::tile {
namespace {

/// `Lanes` floats that one instruction works on, and `Vectors` of them per shapelet in registers.
template <int Lanes, int Vectors>
struct TileLoops {
  typedef float Vector __attribute__((vector_size(Lanes * sizeof(float))));
  static constexpr int kPositions = Lanes * Vectors;

  static Vector Load(const float* from) {
    Vector vector;
    __builtin_memcpy(&vector, from, sizeof(vector));
    return vector;
  }
  static void Store(float* to, Vector vector) { __builtin_memcpy(to, &vector, sizeof(vector)); }
  static Vector Greater(Vector left, Vector right) { return left > right ? left : right; }

  static void FullOverlap(const float* series, const float* shapelets, int length, int count, int stride, float* sums) {
    for (int position = 0; position < count; position += kPositions) {
      Vector sum[kGroup][Vectors] = {};
      for (int m = 0; m < length; ++m) {
        const float* values = shapelets + kGroup * m;
        for (int v = 0; v < Vectors; ++v) {
          const Vector samples = Load(series + position + m + v * Lanes);
          for (int i = 0; i < kGroup; ++i) sum[i][v] += values[i] * samples;
        }
      }
      for (int i = 0; i < kGroup; ++i) {
        for (int v = 0; v < Vectors; ++v) Store(sums + i * stride + position + v * Lanes, sum[i][v]);
      }
    }
  }

  static void PartialOverlaps(const PartialArguments& arguments) {
    const int end = arguments.begin + arguments.count;
    for (int position = arguments.begin; position < end; position += kPositions) PartialTile(arguments, position);
  }

  static void PartialTile(const PartialArguments& arguments, int position) {
    Vector sum[kGroup][Vectors];
    Vector most[kGroup][Vectors] = {};
    for (int i = 0; i < kGroup; ++i) {
      for (int v = 0; v < Vectors; ++v) sum[i][v] = Load(arguments.sums + i * arguments.stride + position + v * Lanes);
    }
    for (int n = 0; n < arguments.steps; ++n) {
      const int m = arguments.first + arguments.direction * n;
      const int window = arguments.window + arguments.direction * n;
      const float* values = arguments.shapelets + kGroup * m;
      const float* within = arguments.within + kGroup * n;
      for (int v = 0; v < Vectors; ++v) {
        const Vector samples = Load(arguments.series + position + m + v * Lanes);
        const Vector scale = Load(arguments.scale + position + window + v * Lanes);
        const Vector offset = Load(arguments.offset + position + window + v * Lanes);
        for (int i = 0; i < kGroup; ++i) {
          sum[i][v] -= values[i] * samples;
          most[i][v] = Greater(most[i][v], sum[i][v] * scale - within[i] * offset);
        }
      }
    }
    for (int i = 0; i < kGroup; ++i) {
      for (int v = 0; v < Vectors; ++v) {
        float* greatest = arguments.greatest + i * arguments.stride + position + v * Lanes;
        Store(greatest, Greater(Load(greatest), most[i][v]));
      }
    }
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
