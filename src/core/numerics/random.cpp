#include "core/numerics/random.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace contact_shapelets::core {

std::uint64_t StreamSeed(std::uint64_t seed, std::uint32_t stream) {
  std::seed_seq mixer{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U), stream};
  std::array<std::uint32_t, 2> words{};
  mixer.generate(words.begin(), words.end());
  return (static_cast<std::uint64_t>(words[1]) << 32U) | words[0];
}

double Random::Normal() {
  constexpr double kTwoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return radius * std::cos(kTwoPi * Uniform());
}

std::vector<int> Random::Sample(int count, int chosen) {
  std::vector<int> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), 0);
  for (int drawn = 0; drawn < chosen; ++drawn) {
    std::swap(indices[static_cast<std::size_t>(drawn)],
              indices[static_cast<std::size_t>(drawn + Index(count - drawn))]);
  }
  indices.resize(static_cast<std::size_t>(chosen));
  return indices;
}

}  // namespace contact_shapelets::core
