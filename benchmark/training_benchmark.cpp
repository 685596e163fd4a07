#include <sys/resource.h>

#include <algorithm>
#include <map>
#include <utility>

#include "benchmark_data.h"
#include "contact_shapelets/core/feature_extractor.h"
#include "contact_shapelets/core/trainer.h"
#include "core/matching/ncc_fftw.h"
#include "core/matching/ncc_kernel.h"
#include "core/numerics/series.h"

namespace contact_shapelets {
namespace {

constexpr int kTrainingEpisodes = 489;
constexpr int kThreads = 2;

core::TrainerOptions Options() {
  core::TrainerOptions options;
  options.threads = kThreads;
  return options;
}

struct Training {
  core::TrainingResult result;
  double seconds = 0.0;
};

Training Train(int episodes) {
  const std::vector<core::Episode> pushes = SwitchPushes(episodes, 4);
  Training training;
  training.seconds = SecondsOf([&] { training.result = core::TrainModel(pushes, Options()); });
  return training;
}

const Training& DefaultTraining() {
  static const Training training = Train(kTrainingEpisodes);
  return training;
}

/// Returns the shapelets by the samples that they span.
std::map<int, std::vector<const core::Shapelet*>> ByLength(const core::Model& model) {
  std::map<int, std::vector<const core::Shapelet*>> groups;
  for (const core::Shapelet& shapelet : model.shapelets) {
    groups[static_cast<int>(shapelet.values.size() - 1) * shapelet.dilation + 1].push_back(&shapelet);
  }
  return groups;
}

/// Returns the seconds that the paper's formulation takes for the features of one push, the median of `pushes`. A
/// dilated shapelet is matched in each phase.
double FftwSecondsPerPush(const core::Model& model, const std::vector<core::Episode>& pushes) {
  double total = 0.0;
  std::map<std::pair<int, int>, std::vector<const core::Shapelet*>> groups;
  for (const core::Shapelet& shapelet : model.shapelets) {
    groups[{shapelet.dilation, static_cast<int>(shapelet.values.size())}].push_back(&shapelet);
  }
  for (const auto& [key, shapelets] : groups) {
    const auto [dilation, length] = key;
    Eigen::MatrixXf rows(shapelets.size(), length);
    for (std::size_t row = 0; row < shapelets.size(); ++row) {
      rows.row(static_cast<Eigen::Index>(row)) = shapelets[row]->values.transpose();
    }
    core::FftwMatcher fftw{core::ShapeletSet(rows)};
    std::vector<double> seconds;
    for (const core::Episode& push : pushes) {
      const Eigen::VectorXf series = core::ZNormalised(push.force);
      seconds.push_back(SecondsOf([&, dilation = dilation, length = length] {
        for (int phase = 0; phase < dilation; ++phase) {
          const Eigen::VectorXf chosen = core::EveryNth(series, phase, dilation);
          if (chosen.size() < length) continue;
          benchmark::DoNotOptimize(fftw.BestMatches(core::WindowSet(chosen, length, 0.3)));
        }
      }));
    }
    total += Quantile(seconds, 0.5);
  }
  return total;
}

/// The reference is the time that the paper's formulation takes for the matches alone: measured on 7 pushes and
/// multiplied by the number of pushes that the training matches, without the rest of a training. Both are processor
/// time of all threads.
void DefaultTrainingAgainstFftw(benchmark::State& state) {
  const std::vector<core::Episode> pushes = SwitchPushes(7, 5);
  for (auto _ : state) {
    const Training& training = DefaultTraining();
    const core::LearnerOptions learner = Options().learner;
    const double matched =
        static_cast<double>(learner.steps) * std::min(learner.batch, kTrainingEpisodes) + kTrainingEpisodes;
    Report(&state, training.seconds, matched * FftwSecondsPerPush(training.result.model, pushes));
  }
}
BENCHMARK(DefaultTrainingAgainstFftw)->Iterations(1)->UseManualTime();

void FeaturesOfOneEpisode(benchmark::State& state) {
  const core::Model& model = DefaultTraining().result.model;
  const core::FeatureExtractor extractor(model.shapelets, model.flat_fraction);
  const std::vector<core::Episode> pushes = SwitchPushes(200, 6);
  core::FeatureMemory memory;
  std::vector<double> seconds;
  for (auto _ : state) {
    for (int round = 0; round < 5; ++round) {
      for (const core::Episode& push : pushes) {
        seconds.push_back(SecondsOf([&] { benchmark::DoNotOptimize(extractor.Compute(push.force, &memory)); }));
      }
    }
    Report(&state, Quantile(seconds, 0.5), FftwSecondsPerPush(model, SwitchPushes(7, 7)));
    const auto groups = ByLength(model);
    state.counters["p99_seconds"] = Quantile(seconds, 0.99);
    state.counters["shapelets"] = static_cast<double>(model.shapelets.size());
    state.counters["shortest"] = groups.begin()->first;
    state.counters["longest"] = groups.rbegin()->first;
  }
}
BENCHMARK(FeaturesOfOneEpisode)->Iterations(1)->UseManualTime();

/// The reference is a training on a tenth of the episodes. Memory is the peak of the process so far, so smaller
/// trainings must run first.
void TrainingOfTenTimesAsMany(benchmark::State& state) {
  const auto episodes = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const double fewer = Train(episodes / 10).seconds;
    Report(&state, Train(episodes).seconds, fewer);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_gigabytes"] = static_cast<double>(usage.ru_maxrss) / 1048576.0;
  }
}
BENCHMARK(TrainingOfTenTimesAsMany)->ArgNames({"N"})->Arg(5000)->Arg(50000)->Iterations(1)->UseManualTime();

}  // namespace
}  // namespace contact_shapelets

BENCHMARK_MAIN();
