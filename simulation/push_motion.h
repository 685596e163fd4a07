#pragma once

#include <Eigen/Core>

#include "push_condition.h"

/// \file
/// The commanded motion of the tool's tip.

namespace contact_shapelets::simulation {

/// What the tip is told at one moment.
struct MotionReference {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// A straight push with limited acceleration: wait, fast approach, slow push, hold, and back to the start; earlier
/// where the force limit is reached, as with a force condition on a robot's linear motion. Between pushes it goes to
/// where the next one starts.
class PushMotion {
 public:
  enum class Phase { kIdle, kWait, kForth, kHold, kReact, kBack };

  /// Takes the tip to be at `position` [m], at rest.
  void PlaceAt(const Eigen::Vector3d& position);
  /// Plans a push that starts `condition.approach` before `contact` [m] and ends `depth` [m] behind it. \throws
  /// std::logic_error while a push goes on.
  void Plan(const PushCondition& condition, const Eigen::Vector3d& contact, double depth);
  /// Begins the planned push. Where the tip is not at the start yet, it begins when it is.
  void Begin();
  /// The reference after another `period` [s]; `force` [N] is the tared estimate that the force limit is applied to.
  MotionReference Advance(double period, double force);

  /// What the motion is doing.
  Phase phase() const { return phase_; }
  /// Start of the planned push [m].
  const Eigen::Vector3d& start() const { return start_; }
  /// True where the force limit ended the push that was begun last.
  bool limit_reached() const { return limit_reached_; }

 private:
  void AdvancePhase(double period, double force);
  /// Moves towards `target` on the path at up to `speed`, braking in time for the target.
  void Follow(double target, double speed, double period);
  MotionReference Reposition(double period);

  PushCondition condition_;
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d idle_position_ = Eigen::Vector3d::Zero();
  double length_ = 0.0;
  Phase phase_ = Phase::kIdle;
  double phase_time_ = 0.0;
  double path_ = 0.0;   ///< [m] from the start
  double speed_ = 0.0;  ///< [m/s]
  bool begin_ = false;
  bool limit_reached_ = false;
};

}  // namespace contact_shapelets::simulation
