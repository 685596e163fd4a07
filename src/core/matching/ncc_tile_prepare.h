#pragma once

#include "core/matching/ncc_tile.h"
#include "core/matching/ncc_tile_vector.h"

/// \file
/// The loops that prepare a series for the search of ncc_tile_loops.h.

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
      // Of all samples that a sum for this window can hold.
      const auto energy = static_cast<double>(arguments.squares[j + 2 * length] - arguments.squares[j - length]);
      const bool hard = inverse * inverse * energy > arguments.hard_ratio;
      const bool counts = inverse != 0.0 && !hard;
      hard_count += hard ? 1 : 0;
      arguments.centred_mean[j] = counts ? static_cast<float>(arguments.mean[j] - arguments.centre) : 0.0F;
      arguments.spread[j] = counts ? static_cast<float>(length / inverse) : kNever;
      arguments.scale[j] = counts ? static_cast<float>(inverse / length) : 0.0F;
    }
    return hard_count;
  }

  /// Returns sum (t - mu_j)^2 over the samples before j + at, minus mu_j^2 j. That term is the same for every `at`, and
  /// only differences are used.
  static Vector EnergyBefore(const BoundArguments& arguments, int window, int at) {
    const Vector mean = Of::LoadOnce(arguments.mean + window);
    const Vector sum = Load(arguments.sums + window + at);
    return Load(arguments.squares + window + at) - mean * (sum + sum - static_cast<float>(at) * mean);
  }

  /// Sets energies[j] to sum (t - mu_j)^2 / (M sigma_j^2), or a little more, over the samples between j + at and the
  /// sample that `fixed` was computed for. `sign` is 1 if that sample comes after j + at, and -1 if it comes before.
  static void Energies(const BoundArguments& arguments, const float* fixed, float sign, int at, float* energies) {
    for (int window = 0; window < arguments.count; window += Lanes) {
      const Vector energy = sign * (Load(fixed + window) - EnergyBefore(arguments, window, at)) + arguments.rounding;
      Of::Store(energies + window, energy * Load(arguments.energy_scale + window));
    }
  }

  /// Returns the largest of `count` >= kPositions values.
  static float LargestOf(const float* values, int count) {
    Vector largest = Load(values + count - Lanes);
    for (int at = 0; at < count - Lanes; at += Lanes) largest = Of::Larger(largest, Load(values + at));
    return Of::Largest(largest);
  }

  /// Sets the bounds of one block in all tiles. `from` is the first window that position 0 reaches in this block.
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
    for (int window = 0; window < arguments.count; window += Lanes) {
      const Vector scale = Load(arguments.scale + window);
      Of::Store(arguments.energy_scale + window, scale * scale * static_cast<float>(length));
      Of::Store(arguments.before_window + window, EnergyBefore(arguments, window, 0));
      Of::Store(arguments.to_window_end + window, EnergyBefore(arguments, window, length));
    }
    for (int block = 0; block * arguments.block < length - 1; ++block) {
      const int least = block * arguments.block + 1;
      const int last = (block + 1) * arguments.block;
      const int most = last < length ? last : length - 1;
      const int span = kPositions + most - least;
      Energies(arguments, arguments.to_window_end, 1.0F, length - most, arguments.heads);
      Energies(arguments, arguments.to_window_end, -1.0F, 2 * length - least, arguments.tails);
      OneBlock(arguments, block, least - length, span, arguments.prefix);
      Energies(arguments, arguments.before_window, -1.0F, most, arguments.heads);
      Energies(arguments, arguments.before_window, 1.0F, least - length, arguments.tails);
      OneBlock(arguments, block, length - most, span, arguments.suffix);
    }
  }
};

}  // namespace
}  // namespace contact_shapelets::core::tile
