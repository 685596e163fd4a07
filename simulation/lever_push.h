#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "contact_shapelets/core/random.h"

/// \file
/// A simple model of a robot pushing the lever of a switch: one direction, two masses, an over-centre spring.

namespace contact_shapelets::simulation {

/// What happens to the switch.
enum class Outcome {
  kSwitched,   ///< the lever snaps over
  kAlreadyOn,  ///< the lever is at its far stop from the start
  kBroken,     ///< the lever is jammed
};

/// The name that recordings carry: "switched", "already_on" or "broken".
std::string NameOf(Outcome outcome);

/// One push. Positions are along the direction of the push; 0 is where the tool meets a lever that is off.
struct PushCondition {
  Outcome outcome = Outcome::kSwitched;
  double delay = 0.3;           ///< [s] from the start of the episode to the first motion
  double approach = 0.03;       ///< [m] free travel before the lever
  double speed = 0.05;          ///< [m/s] of the commanded motion
  double plateau = 15.0;        ///< [N] commanded push against the far stop
  double hold = 0.5;            ///< [s] at the end of the motion
  double stiffness = 2500.0;    ///< [N/m] of the robot's impedance
  double damping_ratio = 0.8;   ///< of the robot's impedance
  double force_limit = 25.0;    ///< [N] at which the push is given up; above the plateau
  double reaction = 0.03;       ///< [s] from that force to the retreat
  double lever_force = 18.0;    ///< [N] greatest force of the over-centre spring at the tool
  double lever_travel = 0.010;  ///< [m] from stop to stop
  double lever_friction = 1.5;  ///< [N]
  double noise = 0.4;           ///< [N] standard deviation of each component of the force
  double ripple = 0.5;          ///< [N] amplitude while moving
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();       ///< [N] of the estimate in free air
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();      ///< [N/s] of that bias
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< of the push, of length 1, in the sensor's frame
};

/// A random condition for `outcome`, with ranges as seen on real cells.
PushCondition SamplePushCondition(Outcome outcome, core::Random* random);

/// Flange force [N, 3] at `rate` [Hz] over `duration` [s], one row per sample, by semi-implicit Euler steps of 50 us.
Eigen::MatrixX3d SimulatePush(const PushCondition& condition, double duration, double rate, core::Random* random);

}  // namespace contact_shapelets::simulation
