#include <algorithm>
#include <cmath>

#include "benchmark_data.h"
#include "core/matching/ncc_fftw.h"
#include "core/matching/ncc_kernel.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"
#include "multiply_add_peak.h"

namespace contact_shapelets {
namespace {

using core::FftwMatcher;
using core::Match;
using core::MatchOptions;
using core::ShapeletSet;
using core::WindowSet;

constexpr int kRounds = 60;

/// Series, and shapelets that are not cut from them.
struct Workload {
  std::vector<Eigen::VectorXf> series;
  Eigen::MatrixXf shapelets;
};

Workload Walks(int length) {
  Workload workload{{}, Eigen::MatrixXf(kShapelets, length)};
  for (int index = 0; index < kRounds; ++index) workload.series.push_back(RandomWalk(kEpisodeLength, 1000 + index));
  for (int k = 0; k < kShapelets; ++k) workload.shapelets.row(k) = RandomWalk(length, 10 + k).transpose();
  return workload;
}

/// Cuts shapelets from other pushes at random, but not from flat parts.
Workload Pushes(int length) {
  Workload workload{{}, Eigen::MatrixXf(kShapelets, length)};
  for (const core::Episode& push : SwitchPushes(kRounds, 1)) workload.series.push_back(core::ZNormalised(push.force));
  const std::vector<core::Episode> others = SwitchPushes(kRounds + kShapelets, 2);
  core::Random random(3);
  for (int k = 0; k < kShapelets; ++k) {
    const Eigen::VectorXf other = core::ZNormalised(others[static_cast<std::size_t>(kRounds + k)].force);
    Eigen::VectorXf cut;
    do {
      cut = other.segment(random.Index(kEpisodeLength - length + 1), length);
    } while (core::StandardDeviation(cut) < 0.3);
    workload.shapelets.row(k) = cut.transpose();
  }
  return workload;
}

Workload WorkloadOf(const benchmark::State& state) {
  const auto length = static_cast<int>(state.range(0));
  return state.range(1) == 0 ? Walks(length) : Pushes(length);
}

double FlatDeviation(const benchmark::State& state) { return state.range(1) == 0 ? 0.0 : 0.3; }

void KernelAgainstFftw(benchmark::State& state) {
  const Workload workload = WorkloadOf(state);
  const ShapeletSet shapelets(workload.shapelets);
  FftwMatcher fftw(shapelets);
  std::vector<double> seconds;
  std::vector<double> reference;
  core::SearchMemory memory;
  std::vector<Match> matches;
  for (auto _ : state) {
    for (const Eigen::VectorXf& series : workload.series) {
      const WindowSet windows(series, shapelets.length(), FlatDeviation(state));
      seconds.push_back(SecondsOf([&] { FindBestMatches(windows, shapelets, {}, MatchOptions{}, &memory, &matches); }));
      reference.push_back(SecondsOf([&] { benchmark::DoNotOptimize(fftw.BestMatches(windows)); }));
    }
    Report(&state, Quantile(seconds, 0.5), Quantile(reference, 0.5));
  }
}
BENCHMARK(KernelAgainstFftw)
    ->ArgNames({"M", "pushes"})
    ->ArgsProduct({{16, 32, 64, 128, 256}, {0, 1}})
    ->Iterations(1)
    ->UseManualTime();

/// Returns the number of multiply-adds that the algebra needs: one for each sample of a full overlap, and two for each
/// shift of each window, one to change the sum by a sample and one for the window's mean. Comparisons with the best are
/// not counted.
double NeededMultiplyAdds(int length) {
  const double windows = kEpisodeLength - length + 1;
  return windows * length + 2.0 * windows * 2.0 * (length - 1);
}

void UnprunedKernelAgainstPeak(benchmark::State& state) {
  const Workload workload = WorkloadOf(state);
  const ShapeletSet shapelets(workload.shapelets);
  constexpr int kPeakRounds = 2000;
  double multiply_adds = 0.0;
  std::vector<double> seconds;
  std::vector<double> peak;
  core::SearchMemory memory;
  std::vector<Match> matches;
  for (auto _ : state) {
    for (const Eigen::VectorXf& series : workload.series) {
      const WindowSet windows(series, shapelets.length(), FlatDeviation(state));
      seconds.push_back(
          SecondsOf([&] { FindBestMatches(windows, shapelets, {}, MatchOptions{false}, &memory, &matches); }));
      peak.push_back(SecondsOf([&] { multiply_adds = MultiplyAdds(core::KernelInstructionSet(), kPeakRounds); }));
    }
    const double at_peak = kShapelets * NeededMultiplyAdds(shapelets.length()) * Quantile(peak, 0.5) / multiply_adds;
    Report(&state, Quantile(seconds, 0.5), at_peak);
  }
}
BENCHMARK(UnprunedKernelAgainstPeak)
    ->ArgNames({"M", "pushes"})
    ->ArgsProduct({{64, 128}, {0}})
    ->Iterations(1)
    ->UseManualTime();

/// The definition as a plain loop over every window, every shift and every sample.
float NaiveBest(const float* series, const float* shapelet, int length) {
  float best = -1.0F;
  std::vector<float> window(static_cast<std::size_t>(length));
  for (int start = 0; start + length <= kEpisodeLength; ++start) {
    float sum = 0.0F;
    for (int m = 0; m < length; ++m) sum += series[start + m];
    const float mean = sum / static_cast<float>(length);
    float squares = 0.0F;
    for (int m = 0; m < length; ++m) squares += (series[start + m] - mean) * (series[start + m] - mean);
    const float deviation = std::sqrt(squares / static_cast<float>(length));
    for (int m = 0; m < length; ++m) window[m] = (series[start + m] - mean) / deviation;
    for (int shift = 1 - length; shift < length; ++shift) {
      float correlation = 0.0F;
      const int end = std::min(length, length - shift);
      for (int m = std::max(0, -shift); m < end; ++m) correlation += shapelet[m] * window[m + shift];
      best = std::max(best, correlation / static_cast<float>(length));
    }
  }
  return best;
}

void KernelAgainstNaiveLoop(benchmark::State& state) {
  const Workload workload = WorkloadOf(state);
  const ShapeletSet shapelets(workload.shapelets);
  std::vector<double> seconds;
  std::vector<double> reference;
  core::SearchMemory memory;
  std::vector<Match> matches;
  for (auto _ : state) {
    for (std::size_t index = 0; index < 20; ++index) {
      const Eigen::VectorXf& series = workload.series[index];
      const WindowSet windows(series, shapelets.length(), FlatDeviation(state));
      seconds.push_back(SecondsOf([&] { FindBestMatches(windows, shapelets, {}, MatchOptions{}, &memory, &matches); }));
      // The naive loop takes equally long for each shapelet, so one is enough.
      const float* shapelet = shapelets.normalised().col(static_cast<Eigen::Index>(index) % kShapelets).data();
      reference.push_back(kShapelets * SecondsOf([&] {
                            benchmark::DoNotOptimize(NaiveBest(series.data(), shapelet, shapelets.length()));
                          }));
    }
    Report(&state, Quantile(seconds, 0.5), Quantile(reference, 0.5));
  }
}
BENCHMARK(KernelAgainstNaiveLoop)->ArgNames({"M", "pushes"})->ArgsProduct({{64}, {0}})->Iterations(1)->UseManualTime();

}  // namespace
}  // namespace contact_shapelets
