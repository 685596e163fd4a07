#pragma once

#include <Eigen/Core>

#include "push_condition.h"

/// \file
/// The commanded motion of the tool's tip.

namespace contact_shapelets::simulation {

/// The commanded position and velocity of the tip.
struct MotionReference {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// A straight push with limited acceleration: wait, fast approach, slow push, hold, and back to the start. The force
/// limit ends a push early, like a force condition on a robot's linear motion. Between pushes the tip goes to the next
/// start.
class PushMotion {
 public:
  enum class Phase { kIdle, kWait, kForth, kHold, kReact, kBack };

  /// Sets the tip's position [m], at rest.
  void PlaceAt(const Eigen::Vector3d& position);
  /// Plans a push that starts `condition.approach` before `contact` [m] and ends `depth` [m] behind it.
  /// \throws std::logic_error during a push.
  void Plan(const PushCondition& condition, const Eigen::Vector3d& contact, double depth);
  /// Begins the planned push as soon as the tip is at its start.
  void Begin();
  /// Returns the reference after another `period` [s]. The force limit applies to `force` [N], the tared estimate.
  MotionReference Advance(double period, double force);

  /// Phase of the motion.
  Phase phase() const { return phase_; }
  /// Start of the planned push [m].
  const Eigen::Vector3d& start() const { return start_; }
  /// True if the force limit ended the last push.
  bool limit_reached() const { return limit_reached_; }

 private:
  void AdvancePhase(double period, double force);
  /// Moves along the path towards `target` at up to `speed`, and brakes in time.
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
