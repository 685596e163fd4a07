#include "core/learning/random_shapelets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/numerics/parallel.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

/// Windows of a z-normalised series with less deviation are flat: they may hold rounding errors alone.
constexpr float kLeastDeviation = 1e-3F;

/// Returns 1 / (length sigma) of the dilated windows of a series; 0 if a window is flat.
Eigen::ArrayXf WindowScales(const Eigen::Ref<const Eigen::VectorXf>& series, int length, int dilation) {
  const Eigen::Index windows = series.size() - Reach(length, dilation) + 1;
  Eigen::ArrayXf sums = Eigen::ArrayXf::Zero(windows);
  for (int m = 0; m < length; ++m) sums += series.segment(m * dilation, windows).array();
  const Eigen::ArrayXf means = sums / static_cast<float>(length);
  Eigen::ArrayXf squares = Eigen::ArrayXf::Zero(windows);
  for (int m = 0; m < length; ++m) squares += (series.segment(m * dilation, windows).array() - means).square();
  const Eigen::ArrayXf deviations = (squares / static_cast<float>(length)).sqrt();
  return (deviations > kLeastDeviation).select((deviations * static_cast<float>(length)).inverse(), 0.0F);
}

/// Computes the normalised cross-correlation of a z-normalised shapelet with each dilated window.
void Correlate(const Eigen::Ref<const Eigen::VectorXf>& series, const Eigen::VectorXf& shapelet, int dilation,
               const Eigen::ArrayXf& scales, Eigen::ArrayXf* correlations) {
  // The shapelet's values sum to zero, so the windows' means drop out.
  correlations->setZero(scales.size());
  for (Eigen::Index m = 0; m < shapelet.size(); ++m) {
    *correlations += shapelet[m] * series.segment(m * dilation, scales.size()).array();
  }
  *correlations *= scales;
}

/// Draws z-normalised dilated subsequences at random and returns the first that is not flat; zeros if all tries are
/// flat.
Eigen::VectorXf DrawnSubsequence(const std::vector<Eigen::VectorXf>& series, int length, int dilation, Random* random) {
  constexpr int kTries = 30;
  const int reach = Reach(length, dilation);
  Eigen::VectorXf values = Eigen::VectorXf::Zero(length);
  for (int attempt = 0; attempt < kTries && values.isZero(); ++attempt) {
    const auto drawn_series = static_cast<std::size_t>(random->Index(static_cast<int>(series.size())));
    const Eigen::VectorXf extended = ExtendedTo(ZNormalised(series[drawn_series]), reach);
    const int start = random->Index(static_cast<int>(extended.size()) - reach + 1);
    const Eigen::VectorXf drawn = EveryNth(extended.segment(start, reach), 0, dilation);
    if (StandardDeviation(drawn) > kLeastDeviation) values = ZNormalised(drawn);
  }
  return values;
}

}  // namespace

RandomShapelets::RandomShapelets(const std::vector<Eigen::VectorXf>& series, int count, std::uint64_t seed) {
  if (series.empty()) throw std::invalid_argument("random shapelets need at least one series");
  for (const Eigen::VectorXf& one : series) {
    if (one.size() < 2) throw std::invalid_argument("a series has fewer than 2 samples");
  }
  const int typical_length = MedianLength(series);
  const int length = std::min(kLength, std::max(3, typical_length / 4));
  const double largest = std::max(1.0, static_cast<double>(typical_length - 1) / (length - 1));
  Random random(seed);
  for (int index = 0; index < count; ++index) {
    const int dilation = std::max(1, static_cast<int>(std::pow(2.0, random.Uniform(0.0, std::log2(largest)))));
    shapelets_.push_back({DrawnSubsequence(series, length, dilation, &random), dilation});
  }
  std::stable_sort(shapelets_.begin(), shapelets_.end(),
                   [](const Shapelet& a, const Shapelet& b) { return a.dilation < b.dilation; });
}

Eigen::VectorXf RandomShapelets::Reaches() const {
  Eigen::VectorXf reaches(count());
  for (int k = 0; k < count(); ++k) {
    const Shapelet& shapelet = shapelets_[static_cast<std::size_t>(k)];
    reaches[k] = static_cast<float>(Reach(static_cast<int>(shapelet.values.size()), shapelet.dilation));
  }
  return reaches;
}

Eigen::MatrixXf RandomShapelets::Distances(const std::vector<Eigen::VectorXf>& series, int threads) const {
  Eigen::MatrixXf distances(series.size(), count());
  ParallelFor(static_cast<int>(series.size()), threads, [&](int row) {
    const Eigen::VectorXf normalised = ZNormalised(series[static_cast<std::size_t>(row)]);
    Eigen::VectorXf extended;
    Eigen::ArrayXf scales;
    Eigen::ArrayXf correlations;
    int dilation = 0;
    for (int k = 0; k < count(); ++k) {
      const Shapelet& shapelet = shapelets_[static_cast<std::size_t>(k)];
      const auto length = static_cast<int>(shapelet.values.size());
      if (shapelet.dilation != dilation) {
        dilation = shapelet.dilation;
        extended = ExtendedTo(normalised, Reach(length, dilation));
        scales = WindowScales(extended, length, dilation);
      }
      Correlate(extended, shapelet.values, dilation, scales, &correlations);
      distances(row, k) = std::sqrt(std::max(0.0F, 1.0F - correlations.maxCoeff()));
    }
  });
  return distances;
}

Eigen::MatrixXf Standardised(const Eigen::Ref<const Eigen::MatrixXf>& features) {
  Eigen::MatrixXf standardised(features.rows(), features.cols());
  for (Eigen::Index column = 0; column < features.cols(); ++column) {
    const double deviation = StandardDeviation(features.col(column));
    const double mean = features.col(column).cast<double>().mean();
    const auto scale = static_cast<float>(deviation > 1e-6 ? 1.0 / deviation : 0.0);
    standardised.col(column) = (features.col(column).array() - static_cast<float>(mean)) * scale;
  }
  return standardised;
}

}  // namespace contact_shapelets::core
