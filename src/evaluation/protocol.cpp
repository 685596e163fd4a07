#include "evaluation/protocol.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::evaluation {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LabelledSeries Chosen(const LabelledSeries& all, std::vector<int> indices) {
  std::sort(indices.begin(), indices.end());
  LabelledSeries chosen;
  chosen.classes.resize(static_cast<Eigen::Index>(indices.size()));
  for (std::size_t index = 0; index < indices.size(); ++index) {
    chosen.series.push_back(all.series[static_cast<std::size_t>(indices[index])]);
    chosen.classes[static_cast<Eigen::Index>(index)] = all.classes[indices[index]];
  }
  return chosen;
}

}  // namespace

EvaluationResult Evaluate(const DataSet& data_set, const std::string& method, std::uint64_t seed,
                          Clusterer* clusterer) {
  const LabelledSeries train = ZNormalisedSeries(data_set.train);
  const LabelledSeries test = ZNormalisedSeries(data_set.test);
  EvaluationResult result;
  result.data_set = data_set.name;
  result.method = method;
  result.seed = seed;
  const auto start = std::chrono::steady_clock::now();
  const Eigen::VectorXi labels = clusterer->Fit(train.series, data_set.class_count, seed);
  result.fit_seconds = SecondsSince(start);
  const auto transform_start = std::chrono::steady_clock::now();
  const Eigen::MatrixXf features = clusterer->Transform(test.series);
  result.transform_ms_per_series = 1e3 * SecondsSince(transform_start) / static_cast<double>(test.series.size());
  result.train = ComparePartitions(labels, train.classes);
  result.test = ComparePartitions(clusterer->Assign(features), test.classes);
  result.test_anew = ComparePartitions(clusterer->ClusterAnew(features), test.classes);
  return result;
}

LabelledSeries ZNormalisedSeries(const LabelledSeries& data) {
  LabelledSeries normalised;
  normalised.classes = data.classes;
  for (const Eigen::VectorXf& series : data.series) normalised.series.push_back(core::ZNormalised(series));
  return normalised;
}

DataSet SplitByClass(const std::string& name, const LabelledSeries& all, int class_count, double train_part,
                     std::uint64_t seed) {
  core::Random random(seed);
  std::vector<int> train;
  std::vector<int> test;
  for (int one = 0; one < class_count; ++one) {
    std::vector<int> members;
    for (int index = 0; index < all.classes.size(); ++index) {
      if (all.classes[index] == one) members.push_back(index);
    }
    const auto count = static_cast<int>(members.size());
    const int wanted = static_cast<int>(std::lround(train_part * count));
    const int training = count < 2 ? count : std::clamp(wanted, 1, count - 1);
    const std::vector<int> order = random.Sample(count, count);
    for (int place = 0; place < count; ++place) {
      (place < training ? train : test).push_back(members[static_cast<std::size_t>(order[place])]);
    }
  }
  DataSet data_set;
  data_set.name = name;
  data_set.train = Chosen(all, train);
  data_set.test = Chosen(all, test);
  data_set.class_count = class_count;
  return data_set;
}

}  // namespace contact_shapelets::evaluation
