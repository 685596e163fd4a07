#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/stream/wrench_sample.h"

/// \file
/// From irregular wrench samples to the magnitude of the contact force at a fixed period.

namespace contact_shapelets::core {

/// Mean force vector [N] of the samples with begin <= time <= end; zero where there is none.
Eigen::Vector3d MeanForce(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end);

/// Magnitude [N] of force less `tare`, one value per `sample_period` [s] from `begin` on, as many as fit before `end`.
///
/// Each value is taken from the mean of the linear interpolant of each force component over its period, which also is
/// the low-pass that a fast stream needs. Before the first and behind the last sample the force is held. `samples` are
/// in order of time and must not be empty. \throws std::invalid_argument where they are, or the period is not above 0.
Eigen::VectorXf ResampledMagnitude(const std::vector<WrenchSample>& samples, Nanoseconds begin, Nanoseconds end,
                                   double sample_period, const Eigen::Vector3d& tare);

}  // namespace contact_shapelets::core
