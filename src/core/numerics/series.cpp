#include "core/numerics/series.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {

double StandardDeviation(const Eigen::Ref<const Eigen::VectorXf>& series) {
  const double mean = series.cast<double>().mean();
  return std::sqrt((series.cast<double>().array() - mean).square().mean());
}

Eigen::VectorXf ZNormalised(const Eigen::Ref<const Eigen::VectorXf>& series) {
  const Eigen::ArrayXd values = series.cast<double>().array();
  const Eigen::ArrayXd centred = values - values.mean();
  const double deviation = std::sqrt(centred.square().mean());
  // Because of rounding, the deviation of a constant series may not be exactly zero.
  if (deviation <= 1e-7 * values.abs().maxCoeff()) return Eigen::VectorXf::Zero(series.size());
  return (centred / deviation).cast<float>().matrix();
}

Eigen::VectorXf StretchedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length) {
  const auto count = static_cast<int>(series.size());
  if (count == length) return series;
  Eigen::VectorXf stretched(length);
  const double step = length > 1 ? static_cast<double>(count - 1) / (length - 1) : 0.0;
  for (int index = 0; index < length; ++index) {
    const double position = step * index;
    const int before = std::min(static_cast<int>(position), count - 1);
    const int after = std::min(before + 1, count - 1);
    const auto part = static_cast<float>(position - before);
    stretched[index] = (1.0F - part) * series[before] + part * series[after];
  }
  return stretched;
}

Eigen::VectorXf ExtendedTo(const Eigen::Ref<const Eigen::VectorXf>& series, int length) {
  if (series.size() >= length) return series;
  Eigen::VectorXf extended(length);
  extended.head(series.size()) = series;
  extended.tail(length - series.size()).setConstant(series[series.size() - 1]);
  return extended;
}

Eigen::VectorXf EveryNth(const Eigen::Ref<const Eigen::VectorXf>& series, int first, int step) {
  if (step == 1) return series.tail(series.size() - first);
  const auto count = static_cast<int>((series.size() - first + step - 1) / step);
  Eigen::VectorXf chosen(count);
  for (int index = 0; index < count; ++index) chosen[index] = series[first + index * step];
  return chosen;
}

int Reach(int length, int dilation) { return (length - 1) * dilation + 1; }

int MedianLength(const std::vector<Eigen::VectorXf>& series) {
  std::vector<int> lengths;
  lengths.reserve(series.size());
  for (const Eigen::VectorXf& one : series) lengths.push_back(static_cast<int>(one.size()));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace contact_shapelets::core
