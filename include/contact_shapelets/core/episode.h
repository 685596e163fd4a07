#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "contact_shapelets/core/time.h"

/// \file
/// One manipulation episode, the input of the learner and the classifier.

namespace contact_shapelets::core {

/// How an episode ended. The values are those of Episode.msg.
enum class EndReason : std::uint8_t {
  kUnknown = 0,  ///< unknown
  kTrigger = 1,  ///< a trigger, service or action closed it
  kContact = 2,  ///< the contact force fell below its threshold
  kTimeout = 3,  ///< it reached `max_duration`
  kStream = 4,   ///< the wrench stopped, or time jumped back
};

/// Returns true if `period` [s] is a valid sample period of an episode: in [0.0001, 1]. A shorter one would fill the
/// memory, a longer one would miss contacts.
inline bool IsSamplePeriod(double period) { return period >= 1e-4 && period <= 1.0; }

/// [N] Greatest valid force. No sensor measures more, and the sum of squares of far greater values overflows single
/// precision.
constexpr double kGreatestForce = 1e6;

/// The magnitude of the contact force over one episode, tared and resampled.
struct Episode {
  std::string id;                              ///< unique within a recording
  std::string frame_id;                        ///< the sensor's frame
  Nanoseconds start = 0;                       ///< time of the first sample
  double sample_period = 0.0;                  ///< [s] see IsSamplePeriod()
  Eigen::VectorXf force;                       ///< [N] at least 0, one value per sample period
  bool complete = true;                        ///< false if the episode is still open or has a fault
  EndReason end_reason = EndReason::kUnknown;  ///< how it ended
  std::string outcome;                         ///< what really happened, as the operator reported it; may be empty

  /// Returns the duration in seconds.
  double duration() const { return sample_period * static_cast<double>(force.size()); }
};

}  // namespace contact_shapelets::core
