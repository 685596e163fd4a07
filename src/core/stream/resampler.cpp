#include "core/stream/resampler.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

/// Integrates the interpolant exactly. Positions only go forward.
class Integrator {
 public:
  Integrator(const std::vector<WrenchSample>& samples, Nanoseconds origin) : samples_(samples), origin_(origin) {
    while (next_ < samples_.size() && samples_[next_].time <= origin_) ++next_;
  }

  /// Returns the integral of each component from the last position to `position` [s from the origin].
  Eigen::Vector3d To(double position) {
    Eigen::Vector3d integral = Eigen::Vector3d::Zero();
    while (next_ < samples_.size() && TimeOf(next_) < position) {
      integral += Piece(TimeOf(next_));
      ++next_;
    }
    return integral + Piece(position);
  }

 private:
  double TimeOf(std::size_t index) const { return ToSeconds(samples_[index].time - origin_); }

  Eigen::Vector3d At(double position) const {
    if (next_ == 0) return samples_.front().force;
    if (next_ == samples_.size()) return samples_.back().force;
    const double before = TimeOf(next_ - 1);
    const double part = (position - before) / (TimeOf(next_) - before);
    return (1.0 - part) * samples_[next_ - 1].force + part * samples_[next_].force;
  }

  Eigen::Vector3d Piece(double position) {
    Eigen::Vector3d area = 0.5 * (At(position_) + At(position)) * (position - position_);
    position_ = position;
    return area;
  }

  const std::vector<WrenchSample>& samples_;
  Nanoseconds origin_;
  std::size_t next_ = 0;
  double position_ = 0.0;
};

}  // namespace

Eigen::Vector3d MeanForce(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const WrenchSample& sample : samples) {
    if (sample.time < begin || sample.time > end) continue;
    sum += sample.force;
    ++count;
  }
  return count > 0 ? Eigen::Vector3d(sum / count) : sum;
}

Eigen::VectorXf ResampledMagnitude(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                                   double sample_period, const Eigen::Vector3d& tare) {
  if (samples.empty()) throw std::invalid_argument("there is no sample to resample");
  if (!(sample_period > 0.0)) throw std::invalid_argument("the sample period must be above 0");
  // The tolerance lets the last period fit despite rounding.
  const auto count = static_cast<int>(std::floor(ToSeconds(end - begin) / sample_period + 1e-6));
  Eigen::VectorXf magnitude(std::max(0, count));
  Integrator integrator(samples, begin);
  for (int index = 0; index < magnitude.size(); ++index) {
    const Eigen::Vector3d mean = integrator.To((index + 1) * sample_period) / sample_period;
    magnitude[index] = static_cast<float>((mean - tare).norm());
  }
  return magnitude;
}

}  // namespace contact_shapelets::core
