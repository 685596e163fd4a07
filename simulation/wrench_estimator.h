#pragma once

#include "cell_model.h"
#include "core/numerics/random.h"

/// \file
/// The robot's own estimate of the external wrench at its flange, from joint torques.

namespace contact_shapelets::simulation {

/// External joint torques, low-passed as by a disturbance observer, turned into a wrench by the damped pseudo-inverse
/// of the transposed Jacobian, with the faults of real torque sensors and models on the way.
class WrenchEstimator {
 public:
  /// Takes new faults. Offsets go over to them within a second or so, but for the first ones; the drift starts anew.
  void SetErrors(const EstimateErrors& errors, std::uint64_t noise_seed);
  /// Adds the faults of each moment; without this the estimate is that of a perfect robot. At 1 kHz.
  void SampleErrors(const CellModel& cell, double period);
  /// Takes the external joint torques of the last step of `period` [s].
  void Advance(const CellModel& cell, double period);
  /// The estimate: force [N], then torque [Nm] about the flange, in the flange's frame. It is what the environment does
  /// to the robot.
  Vector6 Wrench(const CellModel& cell) const;

  static constexpr double kFilterTime = 0.005;  ///< [s] time constant of the observer
  static constexpr double kDamping = 0.01;      ///< of the pseudo-inverse; its square is added to J Jᵀ

 private:
  EstimateErrors errors_;
  core::Random random_{1};
  double time_ = 0.0;
  bool fresh_ = true;
  JointVector offset_ = JointVector::Zero();
  JointVector fault_ = JointVector::Zero();
  JointVector torques_ = JointVector::Zero();
};

}  // namespace contact_shapelets::simulation
