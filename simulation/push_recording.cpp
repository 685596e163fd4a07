#include "push_recording.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace contact_shapelets::simulation {
namespace {

void UseDefaultProgram(PushCondition* condition) {
  const PushCondition program;
  condition->delay = program.delay;
  condition->approach = program.approach;
  condition->approach_speed = program.approach_speed;
  condition->slow_distance = program.slow_distance;
  condition->push_speed = program.push_speed;
  condition->acceleration = program.acceleration;
  condition->plateau = program.plateau;
  condition->hold = program.hold;
  condition->force_limit = program.force_limit;
  condition->reaction = program.reaction;
  condition->stiffness = program.stiffness;
  condition->rotational_stiffness = program.rotational_stiffness;
  condition->damping_ratio = program.damping_ratio;
}

}  // namespace

PushRecording RecordPush(const PushCondition& condition, double duration) {
  SimulatedCell cell(condition);
  PushRecording recording;
  recording.condition = condition;
  recording.states.push_back(cell.state());
  cell.BeginPush();
  const auto cycles = std::lround(duration / SimulatedCell::kPeriod);
  for (std::int64_t cycle = 0; cycle < cycles; ++cycle) recording.states.push_back(cell.Step());
  const auto outcome = cell.ObservedOutcome();
  if (!outcome) throw std::runtime_error("a push takes longer than " + std::to_string(duration) + " s");
  recording.outcome = *outcome;
  return recording;
}

PushRecording RecordOutcome(Outcome outcome, double duration, core::Random* random, const Variation& variation) {
  constexpr int kDraws = 100;
  for (int draw = 0; draw < kDraws; ++draw) {
    PushCondition condition = SamplePushCondition(outcome, random);
    if (variation.one_program) UseDefaultProgram(&condition);
    condition.lever_force *= variation.spring;
    PushRecording recording = RecordPush(condition, duration);
    if (recording.outcome == outcome) return recording;
  }
  throw std::runtime_error("none of " + std::to_string(kDraws) + " pushes had the outcome " + NameOf(outcome));
}

}  // namespace contact_shapelets::simulation
