#pragma once

#include "cell_model.h"
#include "push_motion.h"

/// \file
/// Cartesian impedance control of the arm.

namespace contact_shapelets::simulation {

/// Stiffness and damping as a user sets them.
struct Impedance {
  double stiffness = 2500.0;            ///< [N/m] in each direction
  double rotational_stiffness = 250.0;  ///< [Nm/rad] about each axis
  double damping_ratio = 0.7;           ///< Lehr's damping ratio
};

/// Computes joint torques that make the tool's tip a damped spring about its reference. Gravity and Coriolis torques
/// are compensated.
///
/// The damping matrix follows from stiffness and damping ratio by double diagonalisation with the inertia at the tip
/// (Albu-Schäffer, Ott, Frese, Hirzinger: Cartesian impedance control of redundant robots, ICRA 2003). A soft spring in
/// the null space of the tip's motion holds the elbow.
class ImpedanceController {
 public:
  /// Sets stiffness and damping. The damping takes effect with the next Design().
  void SetImpedance(const Impedance& impedance) { impedance_ = impedance; }
  /// Lets the elbow rest at the arm's present angles.
  void HoldElbow(const CellModel& cell) { elbow_ = cell.JointAngles(); }
  /// Computes damping and null space for the arm's present inertia. Call it before Torques(), and again after the pose
  /// has changed much.
  void Design(const CellModel& cell);
  /// Returns the joint torques [Nm] for the arm's present state. They hold the tool's orientation towards the cabinet.
  JointVector Torques(const CellModel& cell, const MotionReference& reference) const;

 private:
  Impedance impedance_;
  JointVector elbow_ = CellModel::HomeAngles();
  Matrix6 damping_ = Matrix6::Zero();
  JointMatrix null_space_ = JointMatrix::Zero();
};

}  // namespace contact_shapelets::simulation
