#include "push_condition.h"

#include <stdexcept>

namespace contact_shapelets::simulation {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

EstimateErrors SampleErrors(core::Random* random) {
  EstimateErrors errors;
  errors.noise = random->Uniform(0.10, 0.35);
  errors.payload_error = random->Uniform(-0.1, 0.1);
  const double ripple = random->Uniform(0.05, 0.25);
  for (std::size_t joint = 0; joint < kArmJoints; ++joint) {
    // The wrist has smaller sensors and gears.
    const double size = joint < 4 ? 1.0 : 0.3;
    errors.torque_offset[joint] = 0.5 * size * random->Normal();
    errors.gravity_error[joint] = 0.01 * random->Normal();
    errors.ripple[joint] = size * ripple * random->Uniform(0.5, 1.5);
    errors.ripple_phase[joint] = random->Uniform(0.0, 2.0 * kPi);
    errors.drift[joint] = 0.01 * size * random->Normal();
  }
  return errors;
}

}  // namespace

const std::vector<Outcome>& AllOutcomes() {
  static const std::vector<Outcome> all{Outcome::kSwitched,   Outcome::kAlreadyOn, Outcome::kBroken,
                                        Outcome::kSlippedOff, Outcome::kCollision, Outcome::kMissing};
  return all;
}

std::string NameOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kSwitched:
      return "switched";
    case Outcome::kAlreadyOn:
      return "already_on";
    case Outcome::kBroken:
      return "broken";
    case Outcome::kSlippedOff:
      return "slipped_off";
    case Outcome::kCollision:
      return "collision";
    case Outcome::kMissing:
      return "missing";
  }
  return "";
}

Outcome OutcomeOfName(const std::string& name) {
  std::string names;
  for (const Outcome outcome : AllOutcomes()) {
    if (NameOf(outcome) == name) return outcome;
    names += (names.empty() ? "" : ", ") + NameOf(outcome);
  }
  throw std::invalid_argument("an outcome is one of " + names + ", but \"" + name + "\" was given");
}

PushCondition SamplePushCondition(Outcome outcome, core::Random* random) {
  PushCondition condition;
  condition.outcome = outcome;
  condition.delay = random->Uniform(0.20, 0.30);
  condition.approach = random->Uniform(0.055, 0.065);
  condition.approach_speed = random->Uniform(0.11, 0.13);
  condition.slow_distance = random->Uniform(0.013, 0.017);
  condition.push_speed = random->Uniform(0.036, 0.046);
  condition.acceleration = random->Uniform(0.8, 1.2);
  condition.plateau = random->Uniform(12.0, 18.0);
  condition.hold = random->Uniform(0.4, 0.6);
  condition.force_limit = random->Uniform(26.0, 32.0);
  condition.reaction = random->Uniform(0.02, 0.06);
  condition.stiffness = random->Uniform(2000.0, 3000.0);
  condition.rotational_stiffness = random->Uniform(200.0, 300.0);
  condition.damping_ratio = random->Uniform(0.6, 0.9);
  condition.lever_force = random->Uniform(7.0, 9.5);
  condition.lever_friction = random->Uniform(0.2, 1.2);
  condition.finger_friction = random->Uniform(0.15, 0.35);
  condition.height_error = random->Uniform(-0.0015, 0.0015);
  condition.side_error = random->Uniform(-0.002, 0.002);
  condition.tilt = random->Uniform(-2.0, 2.0) * kDegree;
  // If the finger is some 4 mm too far out, the two round ends push each other apart.
  condition.engagement =
      outcome == Outcome::kSlippedOff ? random->Uniform(-0.0055, -0.0038) : random->Uniform(0.003, 0.007);
  condition.jam_travel = random->Uniform(0.5, 5.0) * kDegree;
  condition.obstacle_distance = random->Uniform(condition.slow_distance + 0.005, condition.approach - 0.012);
  condition.errors = SampleErrors(random);
  condition.noise_seed = static_cast<std::uint64_t>(random->Uniform() * 9007199254740992.0);
  return condition;
}

}  // namespace contact_shapelets::simulation
