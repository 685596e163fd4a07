#include "core/change_points/subsequences.h"

#include <cmath>

namespace contact_shapelets::core {
namespace {

/// Standard deviation over root mean square, below which differences are rounding.
constexpr double kFlat = 1e-12;

}  // namespace

void Subsequences::Append(double sample) {
  samples_.push_back(sample);
  const int begin = static_cast<int>(samples_.size()) - window_;
  if (begin < 0) return;
  const Eigen::Map<const Eigen::ArrayXd> values(samples_.data() + begin, window_);
  const double mean = values.mean();
  const double norm = std::sqrt((values - mean).square().sum());
  const bool is_flat = norm <= kFlat * std::sqrt(values.square().sum());
  means_.push_back(mean);
  const double chance = static_cast<double>(tie_breaker_()) / std::minstd_rand::max();
  inverse_norms_.push_back(is_flat ? 0.0 : (1.0 - kTie * chance) / norm);
  // The first subsequence has no predecessor.
  half_steps_.push_back(begin == 0 ? 0.0 : 0.5 * (sample - samples_[begin - 1]));
  edges_.push_back(begin == 0 ? 0.0 : (sample - mean) + (samples_[begin - 1] - means_[begin - 1]));
}

void Subsequences::EraseFirst(int count) {
  for (auto* values : {&samples_, &means_, &inverse_norms_, &half_steps_, &edges_}) {
    values->erase(values->begin(), values->begin() + count);
  }
}

double Subsequences::Covariance(int i, int j) const {
  const Eigen::Map<const Eigen::ArrayXd> first(samples_.data() + i, window_);
  const Eigen::Map<const Eigen::ArrayXd> second(samples_.data() + j, window_);
  return ((first - means_[i]) * (second - means_[j])).sum();
}

}  // namespace contact_shapelets::core
