#include "core/learning/learner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learning/bank_learner.h"
#include "core/learning/shapelet_start.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

constexpr double kZero = 1e-9;

std::vector<Eigen::VectorXf> AllZNormalised(const std::vector<Eigen::VectorXf>& series) {
  std::vector<Eigen::VectorXf> normalised;
  normalised.reserve(series.size());
  for (const Eigen::VectorXf& one : series) {
    if (one.size() < 2) throw std::invalid_argument("a series has fewer than 2 samples");
    if (!one.allFinite()) throw std::invalid_argument("a series holds a value that is not finite");
    normalised.push_back(ZNormalised(one));
  }
  return normalised;
}

/// Returns the first index and the end of the values without leading and trailing zeros, widened to at least `shortest`
/// values.
std::pair<int, int> UsedRange(const Eigen::Ref<const Eigen::VectorXf>& values, int shortest) {
  const auto size = static_cast<int>(values.size());
  int first = 0;
  int end = size;
  while (first < end && std::abs(values[first]) < kZero) ++first;
  while (end > first && std::abs(values[end - 1]) < kZero) --end;
  const int wanted = std::min(shortest, size);
  while (end - first < wanted) {
    if (first > 0) --first;
    if (end < size && end - first < wanted) ++end;
  }
  return {first, end};
}

}  // namespace

int ShapeletCount(int series_count, int series_length, int shapelet_length, int clusters) {
  const double windows = static_cast<double>(series_count) * std::max(1, series_length - shapelet_length) * clusters;
  return std::max(2, static_cast<int>(std::lround(std::log2(windows))));
}

std::vector<ShapeletBank> LearnBanks(const std::vector<Eigen::VectorXf>& series, int clusters,
                                     const LearnerOptions& options, std::uint64_t seed, int threads,
                                     const StepCallback& on_step) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
  if (series.size() < 2) throw std::invalid_argument("learning needs at least 2 series");
  const std::vector<Eigen::VectorXf> normalised = AllZNormalised(series);
  const int typical_length = MedianLength(normalised);

  const SeriesDistances distances(normalised, typical_length);
  std::vector<ShapeletBank> banks;
  for (int index = 0; index < static_cast<int>(options.scales.size()); ++index) {
    const double scale = options.scales[index];
    const int length = std::max(options.shortest, static_cast<int>(scale * typical_length));
    const std::uint64_t bank_seed = StreamSeed(seed, static_cast<std::uint32_t>(index));
    const Eigen::MatrixXf start = StartShapelets(
        normalised, length, ShapeletCount(static_cast<int>(series.size()), typical_length, length, clusters),
        options.flat_fraction, options.start_windows, StreamSeed(bank_seed, 0));
    if (start.rows() == 0) continue;
    BankLearner learner(normalised, distances, start, options, StreamSeed(bank_seed, 1), threads);
    bool stopped = false;
    for (int step = 0; step < options.steps && !stopped; ++step) {
      const double objective = learner.Step();
      stopped = on_step && !on_step(index, step, objective);
    }
    if (stopped) break;
    banks.push_back({scale, learner.shapelets(), learner.objective()});
  }
  return banks;
}

std::vector<Shapelet> CutShapelets(const std::vector<ShapeletBank>& banks, int shortest) {
  std::vector<Shapelet> cut;
  for (int scale = 0; scale < static_cast<int>(banks.size()); ++scale) {
    for (Eigen::Index row = 0; row < banks[scale].shapelets.rows(); ++row) {
      const Eigen::VectorXf values = banks[scale].shapelets.row(row).transpose();
      const auto [first, end] = UsedRange(values, shortest);
      Shapelet shapelet;
      shapelet.scale = scale;
      shapelet.values = ZNormalised(values.segment(first, end - first));
      if (shapelet.values.squaredNorm() > 0.0F) cut.push_back(std::move(shapelet));
    }
  }
  return cut;
}

}  // namespace contact_shapelets::core
