#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/stream/wrench_sample.h"

/// \file
/// Turns irregular wrench samples into the magnitude of the contact force at a fixed period.

namespace contact_shapelets::core {

/// Returns the mean force vector [N] of the samples with begin <= time <= end; zero if there are none.
Eigen::Vector3d MeanForce(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end);

/// Returns the magnitude [N] of force minus `tare`: one value for each `sample_period` [s] that fits in [begin, end].
///
/// Each value is the magnitude of the mean force over its period. The force is interpolated linearly between samples
/// and constant before the first and after the last. The mean is also the low-pass that a fast stream needs. `samples`
/// are in order of time. \throws std::invalid_argument if `samples` are empty or the period is not above 0.
Eigen::VectorXf ResampledMagnitude(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                                   double sample_period, const Eigen::Vector3d& tare);

}  // namespace contact_shapelets::core
