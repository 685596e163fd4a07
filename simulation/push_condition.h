#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/numerics/random.h"

/// \file
/// The parameters that differ from one push of the switch to the next.

namespace contact_shapelets::simulation {

/// The outcome of a push.
enum class Outcome {
  kSwitched,    ///< the lever snaps over
  kAlreadyOn,   ///< the lever is at its far stop from the start
  kBroken,      ///< the lever is jammed; the force limit ends the push
  kSlippedOff,  ///< the finger slides off the lever before it snaps
  kCollision,   ///< the tool hits an obstacle before the switch
  kMissing,     ///< there is no lever
};

/// Returns all outcomes. The first three are those of the paper; the others test novelty.
const std::vector<Outcome>& AllOutcomes();
/// Returns the name in recordings: "switched", "already_on", "broken", "slipped_off", "collision" or "missing".
std::string NameOf(Outcome outcome);
/// Returns the outcome of that name. \throws std::invalid_argument that lists all outcomes if there is none of that
/// name.
Outcome OutcomeOfName(const std::string& name);

constexpr int kArmJoints = 7;
using JointErrors = std::array<double, kArmJoints>;

/// Errors of the robot's estimate of the external wrench, by joint.
struct EstimateErrors {
  JointErrors torque_offset{};  ///< [Nm] offset of each torque sensor
  JointErrors gravity_error{};  ///< relative error of the modelled gravity torque: a bias that depends on the pose
  double payload_error = 0.0;   ///< [kg] real minus configured mass of the tool
  JointErrors ripple{};         ///< [Nm] amplitude of the gears' torque ripple
  JointErrors ripple_phase{};   ///< [rad]
  JointErrors drift{};          ///< [Nm/s] drift of the torque sensors
  double noise = 0.0;           ///< [Nm] standard deviation of each torque sensor at 1 kHz
};

/// One push. The taught contact is the one with a lever that is off, at the taught place of the switch.
struct PushCondition {
  Outcome outcome = Outcome::kSwitched;

  // Set by the user's program.
  double delay = 0.3;                   ///< [s] from the start of the episode to the first motion
  double approach = 0.06;               ///< [m] from the start to the taught contact
  double approach_speed = 0.12;         ///< [m/s]
  double slow_distance = 0.015;         ///< [m] the push's speed begins this far before the taught contact
  double push_speed = 0.04;             ///< [m/s]
  double acceleration = 1.0;            ///< [m/s^2]
  double plateau = 15.0;                ///< [N] spring force at the far stop that the push's end commands
  double hold = 0.5;                    ///< [s] at the end of the push
  double force_limit = 28.0;            ///< [N] tared estimate that ends the push
  double reaction = 0.03;               ///< [s] from that force to the retreat
  double stiffness = 2500.0;            ///< [N/m] of the Cartesian impedance
  double rotational_stiffness = 250.0;  ///< [Nm/rad] of the Cartesian impedance
  double damping_ratio = 0.7;           ///< Lehr's damping ratio of the Cartesian impedance

  // Set by chance.
  double lever_force = 10.0;      ///< [N] greatest force of the over-centre spring at the toggle's end
  double lever_friction = 0.5;    ///< [N] friction of the hinge, at the toggle's end
  double finger_friction = 0.25;  ///< friction coefficient of finger and lever
  double height_error = 0.0;      ///< [m] height of the switch above its taught place
  double side_error = 0.0;        ///< [m] distance of the switch to the side of its taught place
  double engagement = 0.006;      ///< [m] distance that the finger reaches past the toggle's end; below 0 it slips off
  double tilt = 0.0;              ///< [rad] angle of the push from the vertical, towards the cabinet
  double jam_travel = 0.0;        ///< [rad] angle that a jammed lever still turns
  double obstacle_distance = 0.03;  ///< [m] distance of an obstacle before the taught contact

  EstimateErrors errors;
  std::uint64_t noise_seed = 1;
};

/// Returns a random condition for `outcome`. docs/simulation.md gives the ranges and their reasons.
PushCondition SamplePushCondition(Outcome outcome, core::Random* random);

}  // namespace contact_shapelets::simulation
