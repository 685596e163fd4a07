#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "cell_model.h"
#include "impedance_controller.h"
#include "push_condition.h"
#include "push_motion.h"
#include "wrench_estimator.h"

/// \file
/// The whole cell: the robot with its controller and wrench estimate, the switch, and pushes one after the other.

namespace contact_shapelets::simulation {

/// The observable state of the cell.
struct CellState {
  double time = 0.0;                                        ///< [s] since the cell settled
  Vector6 wrench = Vector6::Zero();                         ///< estimate at the flange, in its frame [N, Nm]
  Eigen::Vector3d contact_force = Eigen::Vector3d::Zero();  ///< true force on the finger, in the world's frame [N]
  double tip_height = 0.0;                                  ///< [m]
  double lever_angle = 0.0;                                 ///< [rad], below 0 off
  PushMotion::Phase phase = PushMotion::Phase::kIdle;
};

/// Simulates a robot that pushes a switch, in steps of kPeriod. Equal conditions give equal states.
class SimulatedCell {
 public:
  /// Sets up the switch for `condition`, places the arm at the push's start and lets it settle.
  explicit SimulatedCell(const PushCondition& condition);

  /// Sets up the switch for another push and lets the arm go to its start. \throws std::logic_error during a push.
  void SetUp(const PushCondition& condition);
  /// Begins the push as soon as the arm is at its start.
  void BeginPush();
  /// True from BeginPush() until the push has ended.
  bool IsPushing() const { return begun_ && !finished_; }
  /// Simulates one step of kPeriod.
  const CellState& Step();
  /// The present state.
  const CellState& state() const { return state_; }
  /// Returns the outcome of the last push by the lever, the contacts and the force limit; none before its end. It may
  /// differ from that of the condition: a finger may slip off a stiff lever.
  std::optional<Outcome> ObservedOutcome() const;
  /// The condition of the last SetUp().
  const PushCondition& condition() const { return condition_; }
  /// The model and its state.
  CellModel& model() { return model_; }

  static constexpr double kPeriod = 0.001;  ///< [s] of the robot's cycle

 private:
  void StepPhysics();
  void UpdateState();

  CellModel model_;
  ImpedanceController controller_;
  PushMotion motion_;
  WrenchEstimator estimator_;
  PushCondition condition_;
  CellState state_;
  MotionReference reference_;
  Eigen::Vector3d tare_ = Eigen::Vector3d::Zero();
  double felt_ = 0.0;  ///< [N] tared magnitude of the estimate
  std::int64_t cycle_ = 0;
  bool begun_ = false;
  bool finished_ = false;
  bool started_moving_ = false;
  bool touched_ = false;
};

}  // namespace contact_shapelets::simulation
