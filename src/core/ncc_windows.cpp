#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contact_shapelets/core/ncc.h"
#include "contact_shapelets/core/series.h"
#include "core/ncc_prepared.h"

namespace contact_shapelets::core {

WindowSet::WindowSet(const Eigen::Ref<const Eigen::VectorXf>& series, int length, double flat_deviation)
    : length_(length), series_(series) {
  if (length < 2) throw std::invalid_argument("a window must have at least 2 samples");
  if (length > series.size()) {
    throw std::invalid_argument("a window of " + std::to_string(length) + " samples does not fit into a series of " +
                                std::to_string(series.size()));
  }
  if (!series.allFinite()) throw std::invalid_argument("the series holds a value that is not finite");
  const auto windows = static_cast<int>(series.size()) - length + 1;
  mean_.resize(windows);
  inverse_deviation_.resize(windows);

  // Sums of the centred series keep a large offset from swallowing a small deviation.
  const double centre = series.cast<double>().mean();
  const Eigen::ArrayXd centred = series.cast<double>().array() - centre;
  const double rounding = 1e-6 * std::sqrt(centred.square().mean());
  const double least = std::max(flat_deviation, std::max(rounding, 1e-7 * std::abs(centre)));
  double sum = centred.head(length).sum();
  double squares = centred.head(length).square().sum();
  for (int window = 0; window < windows; ++window) {
    if (window > 0) {
      const double out = centred[window - 1];
      const double in = centred[window + length - 1];
      sum += in - out;
      squares += in * in - out * out;
    }
    const double mean = sum / length;
    const double deviation = std::sqrt(std::max(0.0, squares / length - mean * mean));
    mean_[window] = mean + centre;
    inverse_deviation_[window] = deviation > least ? 1.0 / deviation : 0.0;
    if (deviation > least) ++usable_window_count_;
  }
  FindStretches();
}

void WindowSet::FindStretches() {
  // A stretch costs the positions that windows beside it would share, so that short gaps are not worth another one. It
  // ends in time, since the kernel centres values on the mean of a stretch.
  const int gap = length_ + 64;
  const int most = std::max(1024, 4 * length_);
  for (int window = 0; window < window_count(); ++window) {
    if (IsFlat(window)) continue;
    const bool joins = !stretches_.empty() && window - stretches_.back().first < most &&
                       window - (stretches_.back().first + stretches_.back().count) < gap;
    if (!joins) stretches_.push_back({window, 0});
    stretches_.back().count = window - stretches_.back().first + 1;
  }
}

Eigen::VectorXf WindowSet::NormalisedWindow(int window) const {
  return ((series_.segment(window, length_).cast<double>().array() - mean_[window]) * inverse_deviation_[window])
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
