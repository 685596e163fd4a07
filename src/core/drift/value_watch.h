#pragma once

#include <cstdint>
#include <vector>

#include "core/drift/power_martingale.h"

/// \file
/// Watches one value per episode for a change, without a model of how it scatters.

namespace contact_shapelets::core {

/// Tests whether values are exchangeable with all earlier ones (Vovk, Gammerman and Shafer 2005, chapter 7): each has a
/// conformal p-value among them, on which one martingale bets for greater values and one for smaller values.
class ValueWatch {
 public:
  /// Starts with the values of the training; there may be none.
  explicit ValueWatch(std::vector<double> training);

  /// Takes the next value. `uniform` in [0, 1) is random and breaks ties, so that the p-value is exactly uniform.
  void Append(double value, double uniform);

  const PowerMartingale& greater() const { return greater_; }  ///< bets that values became greater
  const PowerMartingale& smaller() const { return smaller_; }  ///< bets that values became smaller
  std::int64_t count() const { return count_; }                ///< values taken, without those of the training

 private:
  std::vector<double> sorted_;
  PowerMartingale greater_;
  PowerMartingale smaller_;
  std::int64_t count_ = 0;
};

}  // namespace contact_shapelets::core
