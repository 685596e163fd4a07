#include "push_recording.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace contact_shapelets::simulation {

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

PushRecording RecordOutcome(Outcome outcome, double duration, core::Random* random) {
  constexpr int kDraws = 100;
  for (int draw = 0; draw < kDraws; ++draw) {
    PushRecording recording = RecordPush(SamplePushCondition(outcome, random), duration);
    if (recording.outcome == outcome) return recording;
  }
  throw std::runtime_error("none of " + std::to_string(kDraws) + " pushes had the outcome " + NameOf(outcome));
}

}  // namespace contact_shapelets::simulation
