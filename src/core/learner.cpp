#include "contact_shapelets/core/learner.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "contact_shapelets/core/series.h"
#include "contact_shapelets/core/shapelet_start.h"
#include "core/bank_learner.h"

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

/// First and one behind last of the values that are not zero, widened to at least `shortest` values.
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

std::string LearnerOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool well, const char* name, const char* range, double value) {
    if (!well) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(!scales.empty(), "scales", "a list of at least one number", 0.0);
  for (const double scale : scales) require(scale > 0.0 && scale < 1.0, "scales", "in (0, 1)", scale);
  require(repulsion >= 0.0, "repulsion", "at least 0", repulsion);
  require(diversity >= 0.0, "diversity", "at least 0", diversity);
  require(sparsity >= 0.0, "sparsity", "at least 0", sparsity);
  require(flat_fraction >= 0.0 && flat_fraction < 1.0, "flat_fraction", "in [0, 1)", flat_fraction);
  require(steps >= 0, "steps", "at least 0", steps);
  require(learning_rate > 0.0, "learning_rate", "above 0", learning_rate);
  require(batch >= 2, "batch", "at least 2", batch);
  require(start_windows >= 2, "start_windows", "at least 2", start_windows);
  require(shortest >= 2, "shortest", "at least 2", shortest);
  return faults.str();
}

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
