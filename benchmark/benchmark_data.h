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

/// A random walk of normal steps.
Eigen::VectorXf RandomWalk(int count, std::uint64_t seed);

/// `count` switch pushes of kEpisodeLength samples: those of bags/switch_push_train.bag in turn, stretched, each time
/// with fresh noise of 0.3 N. CONTACT_SHAPELETS_BAGS names the folder.
std::vector<core::Episode> SwitchPushes(int count, std::uint64_t seed);

/// Seconds of processor time that `work` takes in all threads. On a machine with other load the time on the clock would
/// grow with the length of what is measured, since long work is interrupted and short work is not.
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

/// The value below which `part` of `values` lie.
double Quantile(std::vector<double> values, double part);

/// Reports a ratio: `seconds` of what is measured, and `reference_seconds` of what it is compared with.
void Report(benchmark::State* state, double seconds, double reference_seconds);

}  // namespace contact_shapelets
