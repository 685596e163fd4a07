#pragma once

#include <vector>

#include "core/numerics/random.h"
#include "simulated_cell.h"

/// \file
/// Recordings of single pushes.

namespace contact_shapelets::simulation {

/// A push and the states of the cell at 1 kHz. The first state is that at the trigger.
struct PushRecording {
  PushCondition condition;
  Outcome outcome = Outcome::kSwitched;  ///< as observed
  std::vector<CellState> states;
};

/// How pushes differ from those that SamplePushCondition() draws.
struct Variation {
  double spring = 1.0;       ///< factor on the force of the lever's spring
  bool one_program = false;  ///< the user's program is the same for all: PushCondition's defaults
};

/// Simulates `duration` [s] of a push in a new cell. \throws std::runtime_error if the push takes longer.
PushRecording RecordPush(const PushCondition& condition, double duration);

/// Returns a push with `outcome`. A condition may lead to another outcome than it is drawn for, so it draws conditions
/// until one leads to `outcome`. \throws std::runtime_error if none of 100 does.
PushRecording RecordOutcome(Outcome outcome, double duration, core::Random* random, const Variation& variation = {});

}  // namespace contact_shapelets::simulation
