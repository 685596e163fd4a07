#include "lever_push.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kStep = 50e-6;             // [s]
constexpr double kToolMass = 2.0;           // [kg] apparent mass of the arm along the push
constexpr double kLeverMass = 0.02;         // [kg] lever's inertia seen at the tool
constexpr double kContactStiffness = 4e4;   // [N/m] of tool, lever and stops
constexpr double kContactDamping = 25.0;    // [N s/m]
constexpr double kFilterTime = 0.008;       // [s] low-pass of the robot's force estimate

/// Force of a one-sided contact for a penetration [m] that grows at `rate` [m/s].
double ContactForce(double penetration, double rate) {
  if (penetration <= 0.0) return 0.0;
  return std::max(0.0, kContactStiffness * penetration + kContactDamping * rate);
}

/// Part of the way at part `time` of the duration: constant speed with rounded ends.
double RoundedRamp(double time) {
  constexpr double kRamp = 0.1;
  constexpr double kScale = 1.0 / (1.0 - kRamp);
  const double clamped = std::clamp(time, 0.0, 1.0);
  if (clamped < kRamp) return 0.5 * kScale * clamped * clamped / kRamp;
  if (clamped > 1.0 - kRamp) return 1.0 - 0.5 * kScale * (1.0 - clamped) * (1.0 - clamped) / kRamp;
  return kScale * (clamped - 0.5 * kRamp);
}

/// The commanded position: wait, approach and push, hold, retreat; earlier where the force limit is reached.
class Motion {
 public:
  explicit Motion(const PushCondition& condition)
      : condition_(condition),
        travel_(condition.approach + condition.lever_travel + condition.plateau / condition.stiffness),
        duration_(travel_ / condition.speed) {}

  double At(double time, double force) {
    if (retreat_at_ < 0.0 && force > condition_.force_limit) retreat_at_ = time + condition_.reaction;
    const double planned = condition_.delay + duration_ + condition_.hold;
    const double retreat = retreat_at_ < 0.0 ? planned : std::min(planned, retreat_at_);
    const double forth = RoundedRamp((std::min(time, retreat) - condition_.delay) / duration_);
    const double back = RoundedRamp((time - retreat) / duration_);
    return -condition_.approach + travel_ * std::max(0.0, forth - back);
  }

 private:
  PushCondition condition_;
  double travel_;
  double duration_;
  double retreat_at_ = -1.0;
};

/// Tool and lever along the direction of the push.
class Cell {
 public:
  explicit Cell(const PushCondition& condition)
      : condition_(condition),
        motion_(condition),
        damping_(2.0 * condition.damping_ratio * std::sqrt(condition.stiffness * kToolMass)),
        tool_(-condition.approach),
        lever_(condition.outcome == Outcome::kAlreadyOn ? condition.lever_travel : 0.0),
        commanded_(tool_) {}

  /// Advances by one step and returns the force [N] between tool and lever as the robot's estimate has it.
  double Step(double time) {
    const double contact = ContactForce(tool_ - lever_, tool_speed_ - lever_speed_);
    // The robot acts on its own, filtered estimate of the force.
    felt_ += kStep / kFilterTime * (contact - felt_);
    const double commanded = motion_.At(time, felt_);
    commanded_speed_ = (commanded - commanded_) / kStep;
    commanded_ = commanded;
    const double drive = condition_.stiffness * (commanded - tool_) + damping_ * (commanded_speed_ - tool_speed_);
    tool_speed_ += kStep * (drive - contact) / kToolMass;
    tool_ += kStep * tool_speed_;
    MoveLever(contact);
    return felt_;
  }

  /// True while the robot is told to move.
  bool IsMoving() const { return std::abs(commanded_speed_) > 0.002; }

 private:
  void MoveLever(double contact) {
    if (condition_.outcome == Outcome::kBroken) return;
    // The spring resists up to half of the travel and drives the lever to the far stop beyond.
    const double part = lever_ / condition_.lever_travel;
    const double spring = -condition_.lever_force * std::sin(2.0 * kPi * std::clamp(part + 0.03, 0.0, 1.0));
    const double stops = ContactForce(-lever_, -lever_speed_) -
                         ContactForce(lever_ - condition_.lever_travel, lever_speed_);
    const double friction = condition_.lever_friction * std::tanh(lever_speed_ / 0.002) + 2.0 * lever_speed_;
    lever_speed_ += kStep * (contact + spring + stops - friction) / kLeverMass;
    lever_ += kStep * lever_speed_;
  }

  PushCondition condition_;
  Motion motion_;
  double damping_;
  double tool_;
  double tool_speed_ = 0.0;
  double lever_;
  double lever_speed_ = 0.0;
  double commanded_;
  double commanded_speed_ = 0.0;
  double felt_ = 0.0;
};

double InRange(double low, double high, core::Random* random) { return random->Uniform(low, high); }

Eigen::Vector3d RandomDirection(core::Random* random) {
  Eigen::Vector3d vector(random->Normal(), random->Normal(), random->Normal());
  return vector.normalized();
}

}  // namespace

std::string NameOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kSwitched:
      return "switched";
    case Outcome::kAlreadyOn:
      return "already_on";
    case Outcome::kBroken:
      return "broken";
  }
  return "";
}

PushCondition SamplePushCondition(Outcome outcome, core::Random* random) {
  PushCondition condition;
  condition.outcome = outcome;
  condition.delay = InRange(0.15, 0.6, random);
  condition.approach = InRange(0.02, 0.05, random);
  condition.speed = InRange(0.035, 0.07, random);
  condition.plateau = InRange(10.0, 20.0, random);
  condition.hold = InRange(0.45, 0.55, random);
  condition.stiffness = InRange(2000.0, 3500.0, random);
  condition.damping_ratio = InRange(0.6, 1.0, random);
  condition.force_limit = condition.plateau + InRange(8.0, 15.0, random);
  condition.reaction = InRange(0.02, 0.06, random);
  condition.lever_force = InRange(0.6, 1.0, random) * condition.plateau;
  condition.lever_travel = InRange(0.008, 0.012, random);
  condition.lever_friction = InRange(0.5, 2.5, random);
  condition.noise = InRange(0.2, 1.0, random);
  condition.ripple = InRange(0.2, 0.8, random);
  condition.bias = InRange(1.0, 5.0, random) * RandomDirection(random);
  condition.drift = InRange(0.0, 0.3, random) * RandomDirection(random);
  condition.direction = (Eigen::Vector3d::UnitX() + 0.15 * RandomDirection(random)).normalized();
  return condition;
}

Eigen::MatrixX3d SimulatePush(const PushCondition& condition, double duration, double rate, core::Random* random) {
  const auto samples = static_cast<Eigen::Index>(std::lround(duration * rate));
  Eigen::MatrixX3d forces(samples, 3);
  Cell cell(condition);
  const double ripple_frequency = 6.0 + 4.0 * random->Uniform();
  double felt = 0.0;
  double time = 0.0;
  for (Eigen::Index row = 0; row < samples; ++row) {
    for (; time < static_cast<double>(row) / rate; time += kStep) {
      felt = cell.Step(time);
    }
    const double ripple = cell.IsMoving() ? condition.ripple * std::sin(2.0 * kPi * ripple_frequency * time) : 0.0;
    const Eigen::Vector3d noise(random->Normal(), random->Normal(), random->Normal());
    forces.row(row) = (condition.direction * (felt + ripple) + condition.bias + time * condition.drift +
                       condition.noise * noise)
                          .transpose();
  }
  return forces;
}

}  // namespace contact_shapelets::simulation
