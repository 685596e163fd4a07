#pragma once

#include <vector>

#include "core/numerics/random.h"
#include "simulated_cell.h"

/// \file
/// One push from its trigger on, as a recorder beside the robot would have it.

namespace contact_shapelets::simulation {

/// A push with the state of the cell at 1 kHz; the first state is the one at the trigger.
struct PushRecording {
  PushCondition condition;
  Outcome outcome = Outcome::kSwitched;  ///< as observed
  std::vector<CellState> states;
};

/// Simulates `duration` [s] of a push in a cell of its own. \throws std::runtime_error where the push takes longer.
PushRecording RecordPush(const PushCondition& condition, double duration);

/// A push that goes as `outcome` says: conditions are drawn until one does, since not every draw does what it was made
/// for. \throws std::runtime_error where none of 100 does.
PushRecording RecordOutcome(Outcome outcome, double duration, core::Random* random);

}  // namespace contact_shapelets::simulation
