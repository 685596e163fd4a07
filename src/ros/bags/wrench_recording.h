#pragma once

#include <Eigen/Core>
#include <string>

#include "contact_shapelets/core/time.h"
#include "contact_shapelets/ros/wrench_source.h"

/// \file
/// The whole wrench of a bag as one series, without episodes.

namespace contact_shapelets {

/// The magnitude of the force over a whole bag.
struct WrenchRecording {
  std::string topic;
  core::Nanoseconds begin = 0;  ///< time of the first sample, on the clock of the stamps, or of receipt without stamps
  double sample_period = 0.0;   ///< [s]
  Eigen::VectorXf force;        ///< [N] as measured, without tare; one value each sample period
};

/// Reads the WrenchStamped topic of the bag `path` and resamples the magnitude of its force to `sample_period` [s].
/// `wrench_topic` names the topic, which may be of another type that `source` describes; if it is empty, the bag must
/// have only one. Leaves out samples that are not finite,
/// above core::kGreatestForce, or not after the sample before. Gaps are interpolated.
/// \throws std::runtime_error in one line that names the bag: it cannot be read, the topic is missing or one of
/// several,
///   or it holds fewer than 2 samples or more than 1e8 sample periods.
WrenchRecording ReadWrenchRecording(const std::string& path, const std::string& wrench_topic, double sample_period,
                                    const WrenchSource& source = {});

}  // namespace contact_shapelets
