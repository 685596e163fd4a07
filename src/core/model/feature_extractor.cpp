#include "contact_shapelets/core/feature_extractor.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/learning/membership.h"
#include "core/matching/ncc_kernel.h"
#include "core/numerics/parallel.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

ShapeletSet SetOf(const std::vector<Shapelet>& shapelets, const std::vector<int>& members) {
  Eigen::MatrixXf rows(members.size(), shapelets[static_cast<std::size_t>(members.front())].values.size());
  for (std::size_t row = 0; row < members.size(); ++row) {
    rows.row(static_cast<Eigen::Index>(row)) = shapelets[static_cast<std::size_t>(members[row])].values.transpose();
  }
  return ShapeletSet(rows);
}

/// Sets `values` to every `step`-th value of `series` from `first` on. Extends a series shorter than `length` by its
/// last value.
void TakeEveryNth(const Eigen::Ref<const Eigen::VectorXf>& series, int length, int first, int step,
                  std::vector<float>* values) {
  const auto size = static_cast<int>(series.size());
  values->clear();
  for (int index = first; index < std::max(size, length); index += step) {
    values->push_back(series[std::min(index, size - 1)]);
  }
}

}  // namespace

struct FeatureMemory::Arrays {
  std::vector<float> values;
  WindowSet windows;
  SearchMemory search;
  std::vector<Match> matches;
};

FeatureMemory::FeatureMemory() : arrays_(std::make_unique<Arrays>()) {}
FeatureMemory::~FeatureMemory() = default;
FeatureMemory::FeatureMemory(FeatureMemory&&) noexcept = default;
FeatureMemory& FeatureMemory::operator=(FeatureMemory&&) noexcept = default;

/// Shapelets of equal length and dilation share the statistics of the windows.
struct FeatureExtractor::Group {
  int dilation;
  std::vector<int> shapelets;
  ShapeletSet set;
};

FeatureExtractor::FeatureExtractor(const std::vector<Shapelet>& shapelets, double flat_fraction)
    : shapelet_count_(static_cast<int>(shapelets.size())), flat_fraction_(flat_fraction) {
  if (shapelets.empty()) throw std::invalid_argument("there is no shapelet");
  std::map<std::pair<int, int>, std::vector<int>> members;
  for (int index = 0; index < shapelet_count_; ++index) {
    const Shapelet& shapelet = shapelets[static_cast<std::size_t>(index)];
    if (shapelet.values.size() < 2) throw std::invalid_argument("a shapelet has fewer than 2 values");
    if (shapelet.dilation < 1) throw std::invalid_argument("a shapelet has a dilation below 1");
    members[{shapelet.dilation, static_cast<int>(shapelet.values.size())}].push_back(index);
  }
  std::vector<Group> groups;
  for (const auto& [key, indices] : members) groups.push_back({key.first, indices, SetOf(shapelets, indices)});
  groups_ = std::make_shared<const std::vector<Group>>(std::move(groups));
}

ShapeletDistances FeatureExtractor::Compute(const Eigen::Ref<const Eigen::VectorXf>& series) const {
  FeatureMemory memory;
  return Compute(series, &memory);
}

ShapeletDistances FeatureExtractor::Compute(const Eigen::Ref<const Eigen::VectorXf>& series,
                                            FeatureMemory* memory) const {
  if (series.size() < 2) throw std::invalid_argument("the series has fewer than 2 samples");
  if (!series.allFinite()) throw std::invalid_argument("the series holds a value that is not finite");
  ShapeletDistances result;
  result.distances = Eigen::VectorXf::Ones(shapelet_count_);
  result.match_start = Eigen::VectorXi::Constant(shapelet_count_, -1);
  result.match_span = Eigen::VectorXi::Zero(shapelet_count_);
  const double flat_deviation = flat_fraction_ * StandardDeviation(series);
  FeatureMemory::Arrays& arrays = memory->arrays();
  const std::vector<Match>& matches = arrays.matches;
  for (const Group& group : *groups_) {
    const int reach = Reach(group.set.length(), group.dilation);
    const int samples = std::max(reach, static_cast<int>(series.size()));
    for (int phase = 0; phase < group.dilation && phase + reach <= samples; ++phase) {
      TakeEveryNth(series, reach, phase, group.dilation, &arrays.values);
      const Eigen::Map<const Eigen::VectorXf> values(arrays.values.data(),
                                                     static_cast<Eigen::Index>(arrays.values.size()));
      arrays.windows.Assign(values, group.set.length(), flat_deviation);
      FindBestMatches(arrays.windows, group.set, {}, MatchOptions{}, &arrays.search, &arrays.matches);
      for (std::size_t member = 0; member < matches.size(); ++member) {
        const int index = group.shapelets[member];
        const float distance = 1.0F - matches[member].similarity;
        const bool first = result.match_start[index] < 0;
        if (matches[member].window < 0 || (!first && distance >= result.distances[index])) continue;
        result.distances[index] = distance;
        result.match_start[index] = phase + matches[member].window * group.dilation;
        result.match_span[index] = reach;
      }
    }
  }
  result.memberships = Membership(result.distances);
  return result;
}

Eigen::MatrixXf FeatureExtractor::Distances(const std::vector<Eigen::VectorXf>& series, int threads) const {
  Eigen::MatrixXf distances(series.size(), shapelet_count_);
  ParallelFor(static_cast<int>(series.size()), threads, [&](int row) {
    distances.row(row) = Compute(series[static_cast<std::size_t>(row)]).distances.transpose();
  });
  return distances;
}

}  // namespace contact_shapelets::core
