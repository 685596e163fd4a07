#pragma once

#include <benchmark/benchmark.h>
#include <time.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets {

constexpr int kEpisodeLength = 433;
constexpr int kShapelets = 19;

/// Returns a random walk of `count` normal steps.
Eigen::VectorXf RandomWalk(int count, std::uint64_t seed);

/// Returns `count` switch pushes of kEpisodeLength samples: those of bags/switch_push_train.bag in turn, stretched,
/// each with fresh noise of 0.3 N. The environment variable CONTACT_SHAPELETS_BAGS names the folder of the bag.
///
/// \throws std::runtime_error if it is not set.
std::vector<core::Episode> SwitchPushes(int count, std::uint64_t seed);

/// Returns the seconds of processor time that `work` takes in all threads. Time on the clock would not compare on a
/// machine with other load, which interrupts long work but not short work.
template <typename Work>
double SecondsOf(const Work& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// Returns the quantile `part` [0, 1] of `values`.
double Quantile(std::vector<double> values, double part);

/// Reports the two sides of a ratio: the measured `seconds`, and the `reference_seconds` that they are compared with.
void Report(benchmark::State* state, double seconds, double reference_seconds);

}  // namespace contact_shapelets
