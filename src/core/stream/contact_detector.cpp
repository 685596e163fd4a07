#include "core/stream/contact_detector.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

/// [N/s] Drift is slower, contact is faster.
constexpr double kGreatestDrift = 1.5;
/// [s] Time constants of the two means that give the slope.
constexpr double kFast = 0.1;
constexpr double kSlow = 0.4;
/// [s] Time constant of the noise.
constexpr double kNoise = 1.0;
/// [N^2] Squared steps up to this count as noise from the start on.
constexpr double kLeastStep = 0.01;
/// The slope that noise makes exceeds this multiple of its deviation hardly ever.
constexpr double kNoiseFactor = 3.5;
/// A force that is quiet for this long rests.
constexpr Nanoseconds kQuiet = 500'000'000;
/// A change of pose moves the free-air force for at most this long.
constexpr Nanoseconds kMove = 750'000'000;

}  // namespace

std::optional<ContactDetector::Change> ContactDetector::AddSample(const WrenchSample& sample, Nanoseconds arrival) {
  FollowMeans(sample);
  if (!has_baseline_) {
    if (sample.time - quiet_since_ < kQuiet) return std::nullopt;
    has_baseline_ = true;
    baseline_ = slow_mean_;
  }
  if (free_air_ && (sample.force - *free_air_).norm() < options_.contact_off) {
    baseline_ = *free_air_;
    free_air_.reset();
  }
  if (in_contact_ && IsFreeAirAnew(sample.time)) {
    in_contact_ = false;
    crossing_ = false;
    free_air_ = baseline_;
    baseline_ = *rest_;
    return Change{false, sample.time, arrival, true};
  }
  return Cross(sample, arrival);
}

/// Two running means of different time constants differ by the slope times the difference of the constants.
void ContactDetector::FollowMeans(const WrenchSample& sample) {
  if (!started_) {
    started_ = true;
    first_time_ = last_time_ = quiet_since_ = moving_since_ = sample.time;
    fast_mean_ = slow_mean_ = last_force_ = sample.force;
  }
  interval_ = ToSeconds(sample.time - last_time_);
  const double step = (sample.force - last_force_).squaredNorm();
  last_time_ = sample.time;
  last_force_ = sample.force;
  fast_mean_ += std::min(1.0, interval_ / kFast) * (sample.force - fast_mean_);
  slow_mean_ += std::min(1.0, interval_ / kSlow) * (sample.force - slow_mean_);
  const double slope = (fast_mean_ - slow_mean_).norm() / (kSlow - kFast);
  // A step beyond the usual ones is a contact, not noise.
  noise_ += std::min(1.0, interval_ / kNoise) * (std::min(step, 9.0 * noise_ + kLeastStep) - noise_);
  const double slope_of_noise = std::sqrt(0.5 * noise_ * std::min(1.0, 0.5 * interval_ / kFast)) / (kSlow - kFast);
  if (slope >= std::max(kGreatestDrift, kNoiseFactor * slope_of_noise)) {
    quiet_since_ = sample.time;
  } else {
    moving_since_ = sample.time;
  }
}

bool ContactDetector::IsFreeAirAnew(Nanoseconds time) {
  if (rest_ && (fast_mean_ - *rest_).norm() > options_.contact_on) left_rest_ = true;
  if (time - quiet_since_ < kQuiet) return false;
  const bool returned = rest_ && left_rest_ && (slow_mean_ - *rest_).norm() < 0.5 * options_.contact_off;
  left_rest_ = false;
  rest_ = slow_mean_;
  return returned;
}

std::optional<ContactDetector::Change> ContactDetector::Cross(const WrenchSample& sample, Nanoseconds arrival) {
  const double magnitude = (sample.force - baseline_).norm();
  const bool beyond = in_contact_ ? magnitude < options_.contact_off : magnitude > options_.contact_on;
  if (!beyond) {
    crossing_ = false;
    if (!in_contact_ && sample.time - moving_since_ < kMove) {
      baseline_ += std::min(1.0, interval_ / options_.baseline_duration) * (sample.force - baseline_);
    }
    return std::nullopt;
  }
  if (!crossing_) {
    crossing_ = true;
    crossing_since_ = sample.time;
    crossing_arrival_ = arrival;
  }
  const double hold = in_contact_ ? options_.contact_hold_off : options_.contact_hold_on;
  if (sample.time - crossing_since_ < FromSeconds(hold)) return std::nullopt;
  crossing_ = false;
  in_contact_ = !in_contact_;
  rest_.reset();
  left_rest_ = false;
  const Nanoseconds time = in_contact_ ? crossing_since_ - FromSeconds(options_.pre_trigger) : sample.time;
  return Change{in_contact_, time, crossing_arrival_, false};
}

void ContactDetector::EndContact() {
  if (in_contact_) free_air_ = baseline_;
  in_contact_ = false;
  crossing_ = false;
  baseline_ = last_force_;
}

}  // namespace contact_shapelets::core
