#include "benchmark_data.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "contact_shapelets/ros/episode_bag_reader.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets {

Eigen::VectorXf RandomWalk(int count, std::uint64_t seed) {
  core::Random random(seed);
  Eigen::VectorXf walk(count);
  double sum = 0.0;
  for (int index = 0; index < count; ++index) walk[index] = static_cast<float>(sum += random.Normal());
  return walk;
}

std::vector<core::Episode> SwitchPushes(int count, std::uint64_t seed) {
  const char* folder = std::getenv("CONTACT_SHAPELETS_BAGS");
  if (folder == nullptr) {
    throw std::runtime_error("CONTACT_SHAPELETS_BAGS does not name the folder of the recorded bags");
  }
  static const std::vector<core::Episode> recorded =
      ReadEpisodes(std::string(folder) + "/switch_push_train.bag", BagReaderOptions{}).episodes;
  core::Random random(seed);
  std::vector<core::Episode> pushes;
  for (int index = 0; index < count; ++index) {
    core::Episode push = recorded[static_cast<std::size_t>(index) % recorded.size()];
    push.id = std::to_string(index);
    push.force = core::StretchedTo(push.force, kEpisodeLength);
    push.force = push.force.unaryExpr(
        [&random](float value) { return std::abs(value + static_cast<float>(0.3 * random.Normal())); });
    pushes.push_back(std::move(push));
  }
  return pushes;
}

double Quantile(std::vector<double> values, double part) {
  const auto index = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

void Report(benchmark::State* state, double seconds, double reference_seconds) {
  state->SetIterationTime(seconds);
  state->counters["seconds"] = seconds;
  state->counters["reference_seconds"] = reference_seconds;
}

}  // namespace contact_shapelets
