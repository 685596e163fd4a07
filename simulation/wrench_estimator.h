#pragma once

#include "cell_model.h"
#include "core/numerics/random.h"

/// \file
/// The robot's own estimate of the external wrench at its flange, from joint torques.

namespace contact_shapelets::simulation {

/// Estimates the wrench from external joint torques: a low-pass as in a disturbance observer, then the damped
/// pseudo-inverse of the transposed Jacobian. Adds the errors of real torque sensors and models to the torques.
class WrenchEstimator {
 public:
  /// Sets new errors. The first offsets apply at once; later ones within about a second. The drift starts anew.
  void SetErrors(const EstimateErrors& errors, std::uint64_t noise_seed);
  /// Draws the errors of the next `period` [s]. Call it at 1 kHz. Without it, the estimate is that of a perfect robot.
  void SampleErrors(const CellModel& cell, double period);
  /// Takes the external joint torques of the last step of `period` [s].
  void Advance(const CellModel& cell, double period);
  /// Returns the wrench that the environment exerts on the robot: force [N], then torque [Nm] about the flange, in the
  /// flange's frame.
  Vector6 Wrench(const CellModel& cell) const;

  static constexpr double kFilterTime = 0.005;  ///< [s] time constant of the observer
  static constexpr double kDamping = 0.01;      ///< of the pseudo-inverse; its square is added to J Jᵀ

 private:
  EstimateErrors errors_;
  core::Random random_{1};
  double time_ = 0.0;
  bool fresh_ = true;
  JointVector offset_ = JointVector::Zero();
  JointVector error_torques_ = JointVector::Zero();
  JointVector torques_ = JointVector::Zero();
};

}  // namespace contact_shapelets::simulation
