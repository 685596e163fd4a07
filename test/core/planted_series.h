#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "core/numerics/random.h"

namespace contact_shapelets::core {

/// Returns a noisy series [length] with one pattern at a random place: 0 is a bump, 1 a double step, 2 a short burst.
inline Eigen::VectorXf PlantedSeries(int pattern, int length, Random* random) {
  Eigen::VectorXf series(length);
  for (int q = 0; q < length; ++q) series[q] = static_cast<float>(0.1 * random->Normal());
  const int width = 30;
  const int start = random->Index(length - width);
  for (int q = 0; q < width; ++q) {
    const double phase = static_cast<double>(q) / width;
    const double value = pattern == 0   ? std::sin(M_PI * phase)
                         : pattern == 1 ? (phase < 0.5 ? 1.0 : -1.0)
                                        : std::sin(6.0 * M_PI * phase);
    series[start + q] += static_cast<float>(3.0 * value);
  }
  return series;
}

/// Returns `per_pattern` episodes of each of three patterns, with outcomes "pattern_0" to "pattern_2" and lengths that
/// vary by `spread` samples around 120.
inline std::vector<Episode> PlantedEpisodes(int per_pattern, int spread, std::uint64_t seed) {
  Random random(seed);
  std::vector<Episode> episodes;
  for (int index = 0; index < 3 * per_pattern; ++index) {
    Episode episode;
    episode.id = std::to_string(index);
    episode.sample_period = 0.01;
    episode.outcome = "pattern_" + std::to_string(index % 3);
    episode.force = PlantedSeries(index % 3, 120 - spread / 2 + (spread > 0 ? random.Index(spread) : 0), &random);
    episodes.push_back(episode);
  }
  return episodes;
}

}  // namespace contact_shapelets::core
