#include "push_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace contact_shapelets::simulation {
namespace {

constexpr double kRepositionSpeed = 0.1;  // [m/s] between pushes
constexpr double kArrived = 1e-6;         // [m]
constexpr double kStopping = 5.0;         // [m/s^2] deceleration after the force limit

}  // namespace

void PushMotion::PlaceAt(const Eigen::Vector3d& position) {
  phase_ = Phase::kIdle;
  idle_position_ = position;
  speed_ = 0.0;
}

void PushMotion::Plan(const PushCondition& condition, const Eigen::Vector3d& contact, double depth) {
  if (phase_ != Phase::kIdle) throw std::logic_error("a push is going on");
  condition_ = condition;
  direction_ = Eigen::Vector3d(std::sin(condition.tilt), 0.0, std::cos(condition.tilt));
  start_ = contact - condition.approach * direction_;
  length_ = condition.approach + depth;
  limit_reached_ = false;
}

void PushMotion::Begin() { begin_ = true; }

MotionReference PushMotion::Advance(double period, double force) {
  if (phase_ == Phase::kIdle) return Reposition(period);
  phase_time_ += period;
  AdvancePhase(period, force);
  MotionReference reference;
  reference.position = start_ + path_ * direction_;
  reference.velocity = speed_ * direction_;
  return reference;
}

MotionReference PushMotion::Reposition(double period) {
  MotionReference reference;
  const Eigen::Vector3d way = start_ - idle_position_;
  const double step = kRepositionSpeed * period;
  if (way.norm() > step) {
    idle_position_ += step * way.normalized();
    reference.velocity = kRepositionSpeed * way.normalized();
  } else {
    idle_position_ = start_;
    if (begin_) {
      begin_ = false;
      phase_ = Phase::kWait;
      phase_time_ = 0.0;
      path_ = 0.0;
      speed_ = 0.0;
    }
  }
  reference.position = idle_position_;
  return reference;
}

void PushMotion::AdvancePhase(double period, double force) {
  const auto enter = [this](Phase phase) {
    phase_ = phase;
    phase_time_ = 0.0;
  };
  const bool pushing = phase_ == Phase::kForth || phase_ == Phase::kHold;
  if (pushing && force > condition_.force_limit) {
    limit_reached_ = true;
    enter(Phase::kReact);
  }
  const bool fast = path_ < condition_.approach - condition_.slow_distance;
  const double speed = fast ? condition_.approach_speed : condition_.push_speed;
  switch (phase_) {
    case Phase::kIdle:
      break;
    case Phase::kWait:
      if (phase_time_ >= condition_.delay) enter(Phase::kForth);
      break;
    case Phase::kForth:
      Follow(length_, speed, period);
      if (length_ - path_ < kArrived) enter(Phase::kHold);
      break;
    case Phase::kHold:
      speed_ = 0.0;
      if (phase_time_ >= condition_.hold) enter(Phase::kBack);
      break;
    case Phase::kReact:
      // The controller reacts to the force only after its reaction time.
      if (phase_time_ < condition_.reaction) {
        Follow(length_, speed, period);
      } else {
        speed_ -= std::min(speed_, kStopping * period);
        path_ += speed_ * period;
        if (speed_ <= 0.0) enter(Phase::kBack);
      }
      break;
    case Phase::kBack:
      Follow(0.0, condition_.approach_speed, period);
      if (path_ < kArrived) {
        idle_position_ = start_;
        enter(Phase::kIdle);
      }
      break;
  }
}

void PushMotion::Follow(double target, double speed, double period) {
  const double way = target - path_;
  const double sign = way < 0.0 ? -1.0 : 1.0;
  const double braking = std::sqrt(2.0 * condition_.acceleration * std::abs(way));
  const double wanted = sign * std::min(speed, braking);
  const double change = condition_.acceleration * period;
  // While braking, the speed follows `wanted`. Its slope may exceed the acceleration by a step's rounding.
  speed_ = std::abs(wanted) < speed && wanted * speed_ > 0.0 && std::abs(speed_) >= std::abs(wanted)
               ? wanted
               : speed_ + std::clamp(wanted - speed_, -change, change);
  const double step = speed_ * period;
  if (std::abs(step) >= std::abs(way) && step * way >= 0.0) {
    path_ = target;
    speed_ = 0.0;
  } else {
    path_ += step;
  }
}

}  // namespace contact_shapelets::simulation
