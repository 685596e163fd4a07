#include "core/stream/contact_detector.h"

#include <algorithm>

namespace contact_shapelets::core {

std::optional<ContactDetector::Change> ContactDetector::AddSample(const WrenchSample& sample) {
  if (!started_) {
    started_ = true;
    baseline_ = sample.force;
    last_time_ = sample.time;
  }
  const double interval = ToSeconds(sample.time - last_time_);
  last_time_ = sample.time;
  last_force_ = sample.force;
  if (free_air_ && (sample.force - *free_air_).norm() < options_.contact_off) {
    baseline_ = *free_air_;
    free_air_.reset();
  }
  const double magnitude = (sample.force - baseline_).norm();
  const bool beyond = in_contact_ ? magnitude < options_.contact_off : magnitude > options_.contact_on;
  if (!beyond) {
    crossing_ = false;
    if (!in_contact_) baseline_ += std::min(1.0, interval / options_.baseline_duration) * (sample.force - baseline_);
    return std::nullopt;
  }
  if (!crossing_) {
    crossing_ = true;
    crossing_since_ = sample.time;
  }
  const double hold = in_contact_ ? options_.contact_hold_off : options_.contact_hold_on;
  if (sample.time - crossing_since_ < FromSeconds(hold)) return std::nullopt;
  crossing_ = false;
  in_contact_ = !in_contact_;
  return Change{in_contact_, in_contact_ ? crossing_since_ - FromSeconds(options_.pre_trigger) : sample.time};
}

void ContactDetector::EndContact() {
  if (in_contact_) free_air_ = baseline_;
  in_contact_ = false;
  crossing_ = false;
  baseline_ = last_force_;
}

}  // namespace contact_shapelets::core
