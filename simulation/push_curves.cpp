/// Prints one push of every outcome as CSV, for pictures: the tared force of the estimate at 1 kHz, the true contact
/// force, and the lever's angle.

#include <cstdlib>
#include <iostream>

#include "push_recording.h"

namespace contact_shapelets::simulation {
namespace {

void PrintCurves(std::uint64_t seed) {
  constexpr double kDuration = 4.33;
  constexpr std::size_t kTareSamples = 100;
  std::cout << "outcome,time,force,contact_force,lever_angle,phase\n";
  for (const Outcome outcome : AllOutcomes()) {
    core::Random random(seed);
    const PushRecording recording = RecordOutcome(outcome, kDuration, &random);
    Eigen::Vector3d tare = Eigen::Vector3d::Zero();
    for (std::size_t index = 0; index < kTareSamples; ++index) tare += recording.states[index].wrench.head<3>();
    tare /= static_cast<double>(kTareSamples);
    for (const CellState& state : recording.states) {
      std::cout << NameOf(outcome) << ',' << state.time << ',' << (state.wrench.head<3>() - tare).norm() << ','
                << state.contact_force.norm() << ',' << state.lever_angle << ',' << static_cast<int>(state.phase)
                << '\n';
    }
  }
}

}  // namespace
}  // namespace contact_shapelets::simulation

int main(int argc, char** argv) {
  try {
    contact_shapelets::simulation::PrintCurves(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1);
  } catch (const std::exception& error) {
    std::cerr << "push_curves: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
