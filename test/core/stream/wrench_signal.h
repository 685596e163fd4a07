#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>

#include "core/stream/episode_segmenter.h"
#include "core/stream/wrench_sample.h"

namespace contact_shapelets::core {

/// Nanoseconds in so many seconds, to the nearest.
inline Nanoseconds Time(double seconds) { return static_cast<Nanoseconds>(std::llround(seconds * 1e9)); }

/// A force along z.
inline Eigen::Vector3d AlongZ(double force) { return {0.0, 0.0, force}; }

/// Force along z [N] at a time [s].
using Signal = std::function<double(double)>;

/// A force along z and the noise of a sensor: one that holds its value would count as frozen.
inline Eigen::Vector3d Noisy(double force, int index) { return {index % 2 == 0 ? 1e-5 : 0.0, 0.0, force}; }

/// Feeds `signal` to `segmenter` at `rate` [Hz] from `begin` to `end` [s], each sample arriving `latency` [s] late.
inline void Feed(EpisodeSegmenter* segmenter, const Signal& signal, double begin, double end, double rate = 100.0,
                 double latency = 0.0) {
  const auto count = static_cast<int>(std::lround((end - begin) * rate));
  for (int index = 0; index < count; ++index) {
    const double time = begin + index / rate;
    segmenter->AddSample({Time(time), Noisy(signal(time), index)}, Time(time + latency));
  }
}

}  // namespace contact_shapelets::core
