#include "core/change_points/clasp.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/change_points/classification_profile.h"
#include "core/change_points/nearest_neighbours.h"
#include "core/change_points/sample_check.h"
#include "core/change_points/window_size.h"

namespace contact_shapelets::core {
namespace {

constexpr int kLeastWindow = 3;

/// The means of blocks of `block` samples; a last one that is not full is left out.
Eigen::VectorXd BlockMeans(const Eigen::Ref<const Eigen::VectorXd>& series, int block) {
  Eigen::VectorXd means(series.size() / block);
  for (Eigen::Index index = 0; index < means.size(); ++index)
    means[index] = series.segment(index * block, block).mean();
  return means;
}

/// The change points of a series whose values are well, counted in its samples.
std::vector<ChangePoint> SplitRecursively(const Eigen::VectorXd& series, int window, const ClaspOptions& options) {
  Subsequences subsequences(window);
  for (Eigen::Index index = 0; index < series.size(); ++index) subsequences.Append(series[index]);
  const int margin = options.shortest_segment * window;
  std::vector<std::pair<int, int>> segments = {{0, static_cast<int>(series.size())}};
  std::vector<ChangePoint> points;
  while (!segments.empty()) {
    const auto [begin, end] = segments.back();
    segments.pop_back();
    if (end - begin < 2 * margin) continue;
    const int count = end - begin - window + 1;
    std::vector<int> votes = FindNearestNeighbours(subsequences, begin, count, options.neighbours).Votes(0);
    CorrectVotesOfFlatOnes(subsequences, begin, &votes);
    const std::optional<Split> split = ClassificationProfile(votes, window).Best(margin);
    if (!split || split->p_value > options.significance) continue;
    const int middle = begin + split->index;
    points.push_back({middle, split->score, split->p_value});
    segments.emplace_back(begin, middle);
    segments.emplace_back(middle, end);
  }
  return points;
}

}  // namespace

std::string ClaspOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool well, const char* name, const char* range, double value) {
    if (!well) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(window == 0 || window >= kLeastWindow, "window", "0 or at least 3 samples", window);
  require(neighbours >= 1 && neighbours <= kMostNeighbours, "neighbours", "in [1, 15]", neighbours);
  require(significance > 0.0 && significance < 1.0, "significance", "in (0, 1)", significance);
  require(shortest_segment >= 2, "shortest_segment", "at least 2 windows", shortest_segment);
  require(max_samples >= 100, "max_samples", "at least 100", max_samples);
  return faults.str();
}

ChangePoints FindChangePoints(const Eigen::Ref<const Eigen::VectorXd>& series, const ClaspOptions& options) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
  for (Eigen::Index index = 0; index < series.size(); ++index) CheckSample(series[index], index);
  ChangePoints result;
  result.block = std::max(1, static_cast<int>((series.size() + options.max_samples - 1) / options.max_samples));
  const Eigen::VectorXd blocks = BlockMeans(series, result.block);
  const int window =
      options.window > 0 ? std::max(kLeastWindow, options.window / result.block) : SelectWindowSize(blocks);
  result.window = window * result.block;
  result.points = SplitRecursively(blocks, window, options);
  for (ChangePoint& point : result.points) point.index *= result.block;
  std::sort(result.points.begin(), result.points.end(),
            [](const ChangePoint& left, const ChangePoint& right) { return left.index < right.index; });
  return result;
}

}  // namespace contact_shapelets::core
