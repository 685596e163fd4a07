#include "core/matching/ncc_windows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/matching/ncc_prepared.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {

WindowSet::WindowSet(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation) {
  Assign(series, length, flat_deviation);
}

void WindowSet::Assign(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation) {
  if (length < 2) throw std::invalid_argument("a window must have at least 2 samples");
  if (length > series.size()) {
    throw std::invalid_argument("a window of " + std::to_string(length) + " samples does not fit into a series of " +
                                std::to_string(series.size()));
  }
  if (!series.allFinite()) throw std::invalid_argument("the series holds a value that is not finite");
  length_ = length;
  series_.assign(series.data(), series.data() + series.size());
  FindStatistics(flat_deviation);
  FindStretches();
}

void WindowSet::FindStatistics(double flat_deviation) {
  const auto windows = series_.size() - static_cast<std::size_t>(length_) + 1;
  mean_.resize(windows);
  inverse_deviation_.resize(windows);

  // Sums of the centred series keep a large offset from swallowing a small deviation.
  const auto values = series().cast<double>().array();
  const double centre = values.mean();
  const auto centred = values - centre;
  const double rounding = 1e-6 * std::sqrt(centred.square().mean());
  const double least = std::max(flat_deviation, std::max(rounding, 1e-7 * std::abs(centre)));
  double sum = centred.head(length_).sum();
  double squares = centred.head(length_).square().sum();
  const float* out = series_.data();
  const float* in = series_.data() + length_;
  for (std::size_t window = 0; window + 1 < windows; ++window) {
    mean_[window] = sum;
    inverse_deviation_[window] = squares;
    const double leaves = static_cast<double>(out[window]) - centre;
    const double enters = static_cast<double>(in[window]) - centre;
    sum += enters - leaves;
    squares += enters * enters - leaves * leaves;
  }
  mean_.back() = sum;
  inverse_deviation_.back() = squares;

  // A loop apart from that of the sums, so that roots and divisions of several windows run at the same time.
  Eigen::Map<Eigen::ArrayXd> means(mean_.data(), SizeOf(mean_));
  Eigen::Map<Eigen::ArrayXd> deviations(inverse_deviation_.data(), SizeOf(mean_));
  means /= length_;
  deviations = (deviations / length_ - means.square()).max(0.0).sqrt();
  means += centre;
  for (double& deviation : inverse_deviation_) {
    const double inverse = 1.0 / deviation;
    deviation = deviation > least ? inverse : 0.0;
  }
}

void WindowSet::FindStretches() {
  // Each stretch adds positions before and behind its windows, so a short gap is not worth a new stretch. A stretch
  // must not be too long, because the kernel centres values on its mean.
  const int gap = length_ + 64;
  const int most = std::max(1024, 4 * length_);
  stretches_.clear();
  usable_window_count_ = 0;
  for (int window = 0; window < window_count(); ++window) {
    if (IsFlat(window)) continue;
    ++usable_window_count_;
    const bool joins = !stretches_.empty() && window - stretches_.back().first < most &&
                       window - (stretches_.back().first + stretches_.back().count) < gap;
    if (!joins) stretches_.push_back({window, 0});
    stretches_.back().count = window - stretches_.back().first + 1;
  }
}

Eigen::VectorXf WindowSet::NormalisedWindow(int window) const {
  return ((series().segment(window, length_).cast<double>().array() - mean()[window]) * inverse_deviation()[window])
      .cast<float>()
      .matrix();
}

ShapeletSet::ShapeletSet(const Eigen::Ref<const Eigen::MatrixXf>& shapelets)
    : normalised_(shapelets.cols(), shapelets.rows()) {
  if (shapelets.cols() < 2) throw std::invalid_argument("a shapelet must have at least 2 samples");
  if (!shapelets.allFinite()) throw std::invalid_argument("a shapelet holds a value that is not finite");
  for (Eigen::Index row = 0; row < shapelets.rows(); ++row) {
    normalised_.col(row) = ZNormalised(shapelets.row(row).transpose());
  }
  prepared_ = std::make_shared<const PreparedShapelets>(normalised_);
}

}  // namespace contact_shapelets::core
