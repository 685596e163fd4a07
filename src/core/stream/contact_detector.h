#pragma once

#include <Eigen/Core>
#include <optional>

#include "contact_shapelets/core/segmentation_options.h"
#include "core/stream/wrench_sample.h"

/// \file
/// When the tool touches something: a force threshold with hysteresis over a running free-air baseline.

namespace contact_shapelets::core {

/// Decides on contact from the force alone.
class ContactDetector {
 public:
  /// Uses the parameters contact_*, pre_trigger and baseline_duration of `options`.
  explicit ContactDetector(const SegmentationOptions& options) : options_(options) {}

  /// A change of contact.
  struct Change {
    bool contact;      ///< true where contact began
    Nanoseconds time;  ///< when the episode begins (the pre-trigger time before the contact) or ends
  };

  /// Takes the next sample; returns a change where this sample decides one.
  std::optional<Change> AddSample(const WrenchSample& sample);

  /// Ends the contact and takes the present force for the new baseline, so that a lasting force does not trigger again.
  /// The old baseline returns once the force is within contact_off of it: letting go is no contact.
  void EndContact();

 private:
  SegmentationOptions options_;
  bool started_ = false;
  bool in_contact_ = false;
  bool crossing_ = false;  ///< the force is beyond the threshold that would change the state
  Nanoseconds crossing_since_ = 0;
  Nanoseconds last_time_ = 0;
  Eigen::Vector3d last_force_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> free_air_;  ///< the baseline before a contact that was ended by EndContact()
  Eigen::Vector3d baseline_ = Eigen::Vector3d::Zero();
};

}  // namespace contact_shapelets::core
