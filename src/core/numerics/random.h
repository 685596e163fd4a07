#pragma once

#include <cstdint>
#include <random>
#include <vector>

/// \file
/// Random numbers. Equal seeds give equal numbers on every machine and with every standard library.

namespace contact_shapelets::core {

/// Returns the seed of random sequence number `stream` of those that belong to `seed`. Each purpose takes a stream of
/// its own, so that no sequence repeats another. Mixes by std::seed_seq, which the standard defines exactly.
std::uint64_t StreamSeed(std::uint64_t seed, std::uint32_t stream);

/// A 64-bit Mersenne Twister. It has its own distributions because those of the standard libraries differ.
class Random {
 public:
  /// Seeds the generator; equal seeds give equal sequences.
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), 53 bits.
  double Uniform() { return static_cast<double>(engine_() >> 11U) * (1.0 / 9007199254740992.0); }
  /// Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  /// Uniform in 0 ... count - 1; `count` at least 1.
  int Index(int count) { return static_cast<int>(Uniform() * count); }
  /// Standard normal (Box and Muller 1958).
  double Normal();
  /// Returns `chosen` different indices out of 0 ... count - 1, in random order (partial Fisher-Yates shuffle).
  std::vector<int> Sample(int count, int chosen);

 private:
  std::mt19937_64 engine_;
};

}  // namespace contact_shapelets::core
