#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/numerics/random.h"

/// \file
/// What is different from one push of the switch to the next.

namespace contact_shapelets::simulation {

/// How a push goes.
enum class Outcome {
  kSwitched,    ///< the lever snaps over
  kAlreadyOn,   ///< the lever is at its far stop from the start
  kBroken,      ///< the lever is jammed; the push is given up at the force limit
  kSlippedOff,  ///< the finger slides off the lever before it snaps
  kCollision,   ///< the tool hits an obstacle before the switch
  kMissing,     ///< there is no lever
};

/// All outcomes; the first three are those of the paper, the others are for novelty.
const std::vector<Outcome>& AllOutcomes();
/// The name that recordings carry: "switched", "already_on", "broken", "slipped_off", "collision" or "missing".
std::string NameOf(Outcome outcome);
/// The outcome of that name. \throws std::invalid_argument naming all outcomes where there is none.
Outcome OutcomeOfName(const std::string& name);

constexpr int kArmJoints = 7;
using JointErrors = std::array<double, kArmJoints>;

/// How the robot's estimate of the external wrench is wrong, in terms of its joints.
struct EstimateErrors {
  JointErrors torque_offset{};  ///< [Nm] of each torque sensor, which depends on its history
  JointErrors gravity_error{};  ///< relative error of the modelled gravity torque, hence a bias that depends on pose
  double payload_error = 0.0;   ///< [kg] by which the tool is heavier than the controller was told
  JointErrors ripple{};         ///< [Nm] amplitude of the gears' torque ripple
  JointErrors ripple_phase{};   ///< [rad]
  JointErrors drift{};          ///< [Nm/s] of the torque sensors
  double noise = 0.0;           ///< [Nm] standard deviation of each torque sensor at 1 kHz
};

/// One push. Heights are of the finger's axis, relative to where it is taught to meet a lever that is off.
struct PushCondition {
  Outcome outcome = Outcome::kSwitched;

  // As a user programs it.
  double delay = 0.3;                   ///< [s] from the start of the episode to the first motion
  double approach = 0.06;               ///< [m] from the start to the taught contact
  double approach_speed = 0.12;         ///< [m/s]
  double slow_distance = 0.015;         ///< [m] before the taught contact, from where on the push's speed is used
  double push_speed = 0.04;             ///< [m/s]
  double acceleration = 1.0;            ///< [m/s^2]
  double plateau = 15.0;                ///< [N] that the commanded end of the push asks for at the far stop
  double hold = 0.5;                    ///< [s] at the end of the push
  double force_limit = 28.0;            ///< [N] of the tared estimate at which the push is given up
  double reaction = 0.03;               ///< [s] from that force to the retreat
  double stiffness = 2500.0;            ///< [N/m] of the Cartesian impedance
  double rotational_stiffness = 250.0;  ///< [Nm/rad] of the Cartesian impedance
  double damping_ratio = 0.7;           ///< Lehr's damping ratio of the Cartesian impedance

  // As the cell happens to be.
  double lever_force = 10.0;        ///< [N] greatest force of the over-centre spring at the toggle's end
  double lever_friction = 0.5;      ///< [N] of the hinge, at the toggle's end
  double finger_friction = 0.25;    ///< friction coefficient of finger and lever
  double height_error = 0.0;        ///< [m] by which the switch is higher than taught
  double side_error = 0.0;          ///< [m] by which the switch is beside the taught place
  double engagement = 0.006;        ///< [m] by which the finger reaches past the toggle's end; below 0 it slips off
  double tilt = 0.0;                ///< [rad] of the push from the vertical, towards the cabinet
  double jam_travel = 0.0;          ///< [rad] that a jammed lever still turns
  double obstacle_distance = 0.03;  ///< [m] before the taught contact, of an obstacle in the way

  EstimateErrors errors;
  std::uint64_t noise_seed = 1;
};

/// A random condition for `outcome`. docs/simulation.md gives the ranges and their reasons.
PushCondition SamplePushCondition(Outcome outcome, core::Random* random);

}  // namespace contact_shapelets::simulation
