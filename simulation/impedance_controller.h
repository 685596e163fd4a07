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
  double damping_ratio = 0.7;           ///< Lehr's
};

/// Joint torques that make the tool's tip a damped spring about its reference, with gravity and Coriolis torques
/// compensated.
///
/// The damping matrix follows from stiffness and damping ratio by double diagonalisation with the inertia at the tip
/// (Albu-Schäffer, Ott, Frese, Hirzinger: Cartesian impedance control of redundant robots, ICRA 2003). The elbow is
/// held by a soft spring in the null space of the tip's motion.
class ImpedanceController {
 public:
  /// Sets stiffness and damping, which take effect with the next design of the damping.
  void SetImpedance(const Impedance& impedance) { impedance_ = impedance; }
  /// Lets the elbow rest at the arm's angles of now.
  void HoldElbow(const CellModel& cell) { elbow_ = cell.JointAngles(); }
  /// Computes damping and null space for the arm's inertia of now. Needed once before Torques(), and again where the
  /// pose has changed much.
  void Design(const CellModel& cell);
  /// Joint torques [Nm] for the arm's state of now, with the tool's orientation held towards the cabinet.
  JointVector Torques(const CellModel& cell, const MotionReference& reference) const;

 private:
  Impedance impedance_;
  JointVector elbow_ = CellModel::HomeAngles();
  Matrix6 damping_ = Matrix6::Zero();
  JointMatrix null_space_ = JointMatrix::Zero();
};

}  // namespace contact_shapelets::simulation
