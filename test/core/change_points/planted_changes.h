#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/change_points/change_point.h"
#include "core/numerics/random.h"

namespace contact_shapelets::core {

/// White noise of standard deviation 1.
inline Eigen::VectorXd Noise(int samples, Random* random) {
  Eigen::VectorXd noise(samples);
  for (Eigen::Index index = 0; index < noise.size(); ++index) noise[index] = random->Normal();
  return noise;
}

/// A sine of amplitude 1 with noise of standard deviation 0.1.
inline Eigen::VectorXd Sine(int samples, double period, Random* random) {
  Eigen::VectorXd sine = 0.1 * Noise(samples, random);
  for (int index = 0; index < samples; ++index) sine[index] += std::sin(2.0 * M_PI * index / period);
  return sine;
}

/// The same with a sawtooth.
inline Eigen::VectorXd Sawtooth(int samples, int period, Random* random) {
  Eigen::VectorXd sawtooth = 0.1 * Noise(samples, random);
  for (int index = 0; index < samples; ++index) sawtooth[index] += 2.0 * (index % period) / period - 1.0;
  return sawtooth;
}

inline Eigen::VectorXd Concatenated(const std::vector<Eigen::VectorXd>& parts) {
  Eigen::VectorXd series;
  for (const Eigen::VectorXd& part : parts) {
    series.conservativeResize(series.size() + part.size());
    series.tail(part.size()) = part;
  }
  return series;
}

/// Whether the change points are at `truth`, each at most `tolerance` samples off, and no others.
inline testing::AssertionResult AreAt(const std::vector<ChangePoint>& found, const std::vector<std::int64_t>& truth,
                                      std::int64_t tolerance) {
  bool well = found.size() == truth.size();
  for (std::size_t index = 0; well && index < truth.size(); ++index) {
    well = std::abs(found[index].index - truth[index]) <= tolerance;
  }
  testing::AssertionResult result = well ? testing::AssertionSuccess() : testing::AssertionFailure();
  result << "found";
  for (const ChangePoint& point : found) result << ' ' << point.index;
  return result;
}

}  // namespace contact_shapelets::core
