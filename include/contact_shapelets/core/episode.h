#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "contact_shapelets/core/time.h"

/// \file
/// One manipulation episode, as the learner and the classifier see it.

namespace contact_shapelets::core {

/// How an episode ended; values as in Episode.msg.
enum class EndReason : std::uint8_t {
  kUnknown = 0,  ///< not said
  kTrigger = 1,  ///< closed by its trigger, service or action
  kContact = 2,  ///< the contact force fell below its threshold
  kTimeout = 3,  ///< longer than the longest episode allowed
  kStream = 4,   ///< the wrench stopped, or time jumped back
};

/// Whether `period` [s] may lie between two samples of an episode: in [0.0001, 1]. Beyond it are no sensor and no
/// contact, but as many samples as fill the memory.
inline bool IsSamplePeriod(double period) { return period >= 1e-4 && period <= 1.0; }

/// [N] No sensor measures more: a greater value is a fault. Far greater ones overflow single precision where they are
/// squared and summed.
constexpr double kGreatestForce = 1e6;

/// The magnitude of the contact force over one episode, tared and resampled.
struct Episode {
  std::string id;                              ///< unique within a recording
  std::string frame_id;                        ///< the sensor's frame
  Nanoseconds start = 0;                       ///< time of the first sample
  double sample_period = 0.0;                  ///< [s], see IsSamplePeriod()
  Eigen::VectorXf force;                       ///< [N], at least 0, one value each sample period
  bool complete = true;                        ///< false while open, and where samples are known to be missing
  EndReason end_reason = EndReason::kUnknown;  ///< how it ended
  std::string outcome;                         ///< what really happened, where an operator said so

  /// Duration in seconds.
  double duration() const { return sample_period * static_cast<double>(force.size()); }
};

}  // namespace contact_shapelets::core
