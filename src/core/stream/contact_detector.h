#pragma once

#include <Eigen/Core>
#include <optional>

#include "contact_shapelets/core/segmentation_options.h"
#include "core/stream/wrench_sample.h"

/// \file
/// Detects when the tool touches something: a force threshold with hysteresis over a running free-air baseline.

namespace contact_shapelets::core {

/// Decides on contact from the force alone.
///
/// The force is quiet if it moves by less than 1.5 N/s, or by no more than the slopes that its noise makes. The
/// baseline starts when the force was quiet for half a second. Then it follows the force with the time constant
/// `baseline_duration`. It stands still in contact, and while the force has moved for more than 0.75 s: a change of
/// pose is shorter, drift is slower, so this is a slow contact.
///
/// A force may come to rest within a contact, move away by more than contact_on and return to rest at the same value.
/// Then this value is free air: the sensor re-zeroed, or the stream began in contact.
class ContactDetector {
 public:
  /// Uses the parameters contact_*, pre_trigger and baseline_duration of `options`.
  explicit ContactDetector(const SegmentationOptions& options) : options_(options) {}

  /// A change of contact.
  struct Change {
    bool contact;         ///< true if contact began, false if it ended
    Nanoseconds time;     ///< when the episode begins (`pre_trigger` before the contact) or ends
    Nanoseconds arrival;  ///< when the force crossed the threshold, on the clock of arrivals
    bool zero_moved;      ///< the contact ends because its force turned out to be that of free air
  };

  /// Takes the next sample, which came at `arrival`. Returns a change if this sample decides one.
  std::optional<Change> AddSample(const WrenchSample& sample, Nanoseconds arrival);

  /// Ends the contact and makes the present force the baseline, so that a lasting force does not trigger again. The old
  /// baseline returns when the force comes within contact_off of it, so that letting go does not trigger either.
  void EndContact();

  /// [s] time since the first sample, as long as no baseline was found; else 0.
  double without_baseline() const { return has_baseline_ ? 0.0 : ToSeconds(last_time_ - first_time_); }

 private:
  void FollowMeans(const WrenchSample& sample);
  bool IsFreeAirAnew(Nanoseconds time);
  std::optional<Change> Cross(const WrenchSample& sample, Nanoseconds arrival);

  SegmentationOptions options_;
  bool started_ = false;
  bool has_baseline_ = false;
  bool in_contact_ = false;
  bool crossing_ = false;  ///< the force is beyond the threshold, but not for long enough yet
  Nanoseconds crossing_since_ = 0;
  Nanoseconds crossing_arrival_ = 0;
  Nanoseconds first_time_ = 0;
  Nanoseconds last_time_ = 0;
  double interval_ = 0.0;                ///< [s] since the last sample
  Nanoseconds quiet_since_ = 0;          ///< when the force last moved
  Nanoseconds moving_since_ = 0;         ///< when the force was last quiet
  bool left_rest_ = false;               ///< the force was more than contact_on from `rest_`
  std::optional<Eigen::Vector3d> rest_;  ///< where the force last rested within the contact
  double noise_ = 0.0;                   ///< [N^2] mean squared step from one sample to the next
  Eigen::Vector3d last_force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d fast_mean_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d slow_mean_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> free_air_;  ///< the baseline before a contact that EndContact() ended
  Eigen::Vector3d baseline_ = Eigen::Vector3d::Zero();
};

}  // namespace contact_shapelets::core
