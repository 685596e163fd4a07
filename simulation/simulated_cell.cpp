#include "simulated_cell.h"

#include <cmath>

namespace contact_shapelets::simulation {
namespace {

constexpr int kDesignCycles = 10;               // from one design of the damping to the next
constexpr int kSettleCycles = 300;              // after the arm has been placed
constexpr double kOn = 0.5 * CellModel::kStop;  // [rad] above it the lever is on

}  // namespace

SimulatedCell::SimulatedCell(const PushCondition& condition) {
  SetUp(condition);
  model_.PlaceTip(motion_.start());
  motion_.PlaceAt(motion_.start());
  model_.SetUp(condition);
  controller_.HoldElbow(model_);
  for (int cycle = 0; cycle < kSettleCycles; ++cycle) Step();
  cycle_ = 0;
  state_.time = 0.0;
}

void SimulatedCell::SetUp(const PushCondition& condition) {
  const double depth = model_.LeverTravel(condition.engagement) + condition.plateau / condition.stiffness;
  motion_.Plan(condition, model_.TaughtContact(condition.engagement), depth);
  condition_ = condition;
  model_.SetUp(condition);
  controller_.SetImpedance({condition.stiffness, condition.rotational_stiffness, condition.damping_ratio});
  estimator_.SetErrors(condition.errors, condition.noise_seed);
  begun_ = false;
  finished_ = false;
  started_moving_ = false;
  touched_ = false;
}

void SimulatedCell::BeginPush() {
  begun_ = true;
  finished_ = false;
  motion_.Begin();
}

const CellState& SimulatedCell::Step() {
  if (cycle_ % kDesignCycles == 0) controller_.Design(model_);
  ++cycle_;
  // The force limit applies to the force beyond that in free air before the push.
  const bool waiting = motion_.phase() == PushMotion::Phase::kIdle || motion_.phase() == PushMotion::Phase::kWait;
  if (waiting) tare_ += 0.02 * (state_.wrench.head<3>() - tare_);
  felt_ = (state_.wrench.head<3>() - tare_).norm();
  reference_ = motion_.Advance(kPeriod, felt_);
  estimator_.SampleErrors(model_, kPeriod);
  StepPhysics();
  UpdateState();
  return state_;
}

void SimulatedCell::StepPhysics() {
  const double step = model_.model()->opt.timestep;
  const auto steps = std::lround(kPeriod / step);
  MotionReference reference = reference_;
  // `reference_` is for the end of the cycle.
  reference.position -= kPeriod * reference_.velocity;
  for (std::int64_t count = 0; count < steps; ++count) {
    mj_step1(model_.model(), model_.data());
    Eigen::Map<JointVector>(model_.data()->ctrl) = controller_.Torques(model_, reference);
    mj_step2(model_.model(), model_.data());
    estimator_.Advance(model_, step);
    touched_ = touched_ || (started_moving_ && model_.InContact());
    reference.position += step * reference_.velocity;
  }
}

void SimulatedCell::UpdateState() {
  state_.time = static_cast<double>(cycle_) * kPeriod;
  state_.wrench = estimator_.Wrench(model_);
  state_.contact_force = model_.ContactForce();
  state_.tip_height = model_.Tip().position.z();
  state_.lever_angle = model_.LeverAngle();
  state_.phase = motion_.phase();
  if (!begun_ || finished_) return;
  started_moving_ = started_moving_ || state_.phase == PushMotion::Phase::kForth;
  finished_ = started_moving_ && state_.phase == PushMotion::Phase::kIdle;
}

std::optional<Outcome> SimulatedCell::ObservedOutcome() const {
  if (!finished_) return std::nullopt;
  const bool intact = condition_.outcome != Outcome::kBroken;
  if (!touched_) return Outcome::kMissing;
  if (condition_.outcome == Outcome::kCollision) {
    return motion_.limit_reached() ? Outcome::kCollision : Outcome::kMissing;
  }
  if (condition_.outcome == Outcome::kAlreadyOn) {
    return motion_.limit_reached() ? Outcome::kBroken : Outcome::kAlreadyOn;
  }
  if (intact && state_.lever_angle > kOn) return Outcome::kSwitched;
  return motion_.limit_reached() ? Outcome::kBroken : Outcome::kSlippedOff;
}

}  // namespace contact_shapelets::simulation
