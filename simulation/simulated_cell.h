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
/// The whole cell: robot with controller and wrench estimate, switch, and one push after the other.

namespace contact_shapelets::simulation {

/// What can be seen of the cell at one moment.
struct CellState {
  double time = 0.0;                                        ///< [s] since the cell was made
  Vector6 wrench = Vector6::Zero();                         ///< estimate at the flange, in its frame [N, Nm]
  Eigen::Vector3d contact_force = Eigen::Vector3d::Zero();  ///< true force on the finger, in the world's frame [N]
  double tip_height = 0.0;                                  ///< [m]
  double lever_angle = 0.0;                                 ///< [rad], below 0 off
  PushMotion::Phase phase = PushMotion::Phase::kIdle;
};

/// A robot that pushes a switch, in steps of kPeriod. The same conditions give the same states.
class SimulatedCell {
 public:
  /// Sets the switch up for `condition`, and the arm at its start, at rest and settled.
  explicit SimulatedCell(const PushCondition& condition);

  /// Sets the switch up for another push and lets the arm go to its start. \throws std::logic_error during a push.
  void SetUp(const PushCondition& condition);
  /// Begins the push as soon as the arm is at its start.
  void BeginPush();
  /// True while the arm moves for a push, or is about to.
  bool IsPushing() const { return begun_ && !finished_; }
  /// One step of kPeriod.
  const CellState& Step();
  /// The state of now.
  const CellState& state() const { return state_; }
  /// How the last push went, judged by the lever, the obstacle and the force limit; none before its end. It need not be
  /// what the condition was made for: a finger may slip off a stiff lever.
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
