#include "wrench_estimator.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace contact_shapelets::simulation {
namespace {

// A harmonic drive of 160:1. Its wave generator deforms the spline twice per turn.
constexpr double kRippleCycles = 2.0 * 160.0;
constexpr double kOffsetTime = 0.2;  // [s] time constant by which offsets change from one push to the next

JointVector ToVector(const JointErrors& values) { return Eigen::Map<const JointVector>(values.data()); }

}  // namespace

void WrenchEstimator::SetErrors(const EstimateErrors& errors, std::uint64_t noise_seed) {
  errors_ = errors;
  random_ = core::Random(noise_seed);
  time_ = 0.0;
  if (fresh_) offset_ = ToVector(errors.torque_offset);
  fresh_ = false;
}

void WrenchEstimator::SampleErrors(const CellModel& cell, double period) {
  time_ += period;
  const JointVector angles = cell.JointAngles();
  offset_ += period / kOffsetTime * (ToVector(errors_.torque_offset) - offset_);
  error_torques_ = offset_ + time_ * ToVector(errors_.drift) +
                   ToVector(errors_.gravity_error).cwiseProduct(cell.GravityTorques()) +
                   errors_.payload_error * cell.PayloadTorques();
  for (std::size_t joint = 0; joint < kArmJoints; ++joint) {
    const auto row = static_cast<Eigen::Index>(joint);
    error_torques_[row] += errors_.ripple[joint] * std::sin(kRippleCycles * angles[row] + errors_.ripple_phase[joint]);
    error_torques_[row] += errors_.noise * random_.Normal();
  }
}

void WrenchEstimator::Advance(const CellModel& cell, double period) {
  torques_ += period / kFilterTime * (cell.ExternalTorques() + error_torques_ - torques_);
}

Vector6 WrenchEstimator::Wrench(const CellModel& cell) const {
  const Jacobian jacobian = cell.FlangeJacobian();
  const Matrix6 squared = jacobian * jacobian.transpose() + kDamping * kDamping * Matrix6::Identity();
  const Vector6 wrench = squared.ldlt().solve(jacobian * torques_);
  const Eigen::Matrix3d to_flange = cell.Flange().orientation.transpose();
  Vector6 turned;
  turned << to_flange * wrench.head<3>(), to_flange * wrench.tail<3>();
  return turned;
}

}  // namespace contact_shapelets::simulation
