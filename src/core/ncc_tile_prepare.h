#pragma once

#include "core/ncc_tile.h"
#include "core/ncc_tile_vector.h"

/// \file
/// The loops that prepare a series for those of ncc_tile_loops.h.

namespace contact_shapelets::core::tile {
namespace {

template <int Lanes, int Vectors>
struct PreparationLoops {
  using Of = VectorOf<Lanes>;
  using Vector = typename Of::Floats;
  static constexpr int kPositions = Lanes * Vectors;

  static Vector Load(const float* from) { return Of::template Load<Vector>(from); }

  static int WindowValues(const WindowArguments& arguments) {
    const int length = arguments.length;
    int hard_count = 0;
    for (int j = 0; j < arguments.count; ++j) {
      const double inverse = arguments.inverse[j];
      // All values that a sum at a position near this window can hold.
      const auto energy = static_cast<double>(arguments.squares[j + 2 * length] - arguments.squares[j - length]);
      const bool hard = inverse * inverse * energy > arguments.hard_ratio;
      const bool counts = inverse != 0.0 && !hard;
      hard_count += hard ? 1 : 0;
      arguments.centred_mean[j] = counts ? static_cast<float>(arguments.mean[j] - arguments.centre) : 0.0F;
      arguments.spread[j] = counts ? static_cast<float>(length / inverse) : arguments.spread[j];
      arguments.scale[j] = counts ? static_cast<float>(inverse / length) : 0.0F;
    }
    return hard_count;
  }

  /// energies[j] = sum (t - mu_j)^2 / (M sigma_j^2) over `samples` samples from j + first on, or a little more.
  static void Energies(const BoundArguments& arguments, int first, int samples, float* energies) {
    const float* before = arguments.sums + first;
    const float* squares_before = arguments.squares + first;
    const auto number = static_cast<float>(samples);
    const auto length = static_cast<float>(arguments.length);
    for (int window = 0; window < arguments.count; window += Lanes) {
      const Vector mean = Of::LoadOnce(arguments.mean + window);
      const Vector scale = Of::LoadOnce(arguments.scale + window);
      const Vector sum = Load(before + window + samples) - Load(before + window);
      const Vector square = Load(squares_before + window + samples) - Load(squares_before + window);
      const Vector energy = square - mean * (2.0F * sum - number * mean) + arguments.rounding;
      Of::Store(energies + window, energy * (scale * scale * length));
    }
  }

  static void Fill(const BoundArguments& arguments, int first, int samples, float* energies) {
    if (arguments.unbounded == 0.0F) return Energies(arguments, first, samples, energies);
    for (int window = 0; window < arguments.count; ++window) energies[window] = arguments.unbounded;
  }

  /// The largest of `count` >= kPositions values.
  static float LargestOf(const float* values, int count) {
    Vector largest = Load(values + count - Lanes);
    for (int at = 0; at < count - Lanes; at += Lanes) largest = Of::Larger(largest, Load(values + at));
    return Of::Largest(largest);
  }

  /// One block of all tiles: `from` is the window of position 0 and the block's least overlap, or its most.
  static void OneBlock(const BoundArguments& arguments, int block, int from, int span, Bounds* bounds) {
    for (int tile = 0; tile < arguments.tiles; ++tile) {
      const int window = (tile - arguments.further_tiles) * kPositions + from;
      if (window + span <= 0 || window >= arguments.count) continue;
      bounds[tile].head[block] = LargestOf(arguments.heads + window, span);
      bounds[tile].tail[block] = LargestOf(arguments.tails + window, span);
      bounds[tile].scale[block] = LargestOf(arguments.scale + window, span);
    }
  }

  static void AllBounds(const BoundArguments& arguments) {
    const int length = arguments.length;
    for (int block = 0; block * arguments.block < length - 1; ++block) {
      const int least = block * arguments.block + 1;
      const int last = (block + 1) * arguments.block;
      const int most = last < length ? last : length - 1;
      const int span = kPositions + most - least;
      Fill(arguments, length - most, most, arguments.heads);
      Fill(arguments, length, length - least, arguments.tails);
      OneBlock(arguments, block, least - length, span, arguments.prefix);
      Fill(arguments, 0, most, arguments.heads);
      Fill(arguments, least - length, length - least, arguments.tails);
      OneBlock(arguments, block, length - most, span, arguments.suffix);
    }
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
