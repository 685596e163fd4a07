#include "core/drift/power_martingale.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {
namespace {

/// log(exp(first) + exp(second)) without overflow.
double LogOfSum(double first, double second) {
  const double greater = std::max(first, second);
  return greater + std::log1p(std::exp(std::min(first, second) - greater));
}

/// The weight of all bets that start after `count` p-values: 1 for none, and so slow in falling that a change after
/// thousands of episodes is found soon.
double WeightAfter(std::int64_t count) { return std::log(2.0) / std::log(static_cast<double>(count) + 2.0); }

}  // namespace

void PowerMartingale::Append(double p_value) {
  const double log_weight = std::log(WeightAfter(count_) - WeightAfter(count_ + 1));
  ++count_;
  const double log_p = std::log(p_value);
  for (std::size_t index = 0; index < bets_.size(); ++index) {
    const double log_bet = std::log(kExponents[index]) + (kExponents[index] - 1.0) * log_p;
    Bets& bets = bets_[index];
    bets.log_sum = LogOfSum(bets.log_sum, log_weight) + log_bet;
    if (bets.gain <= 0.0) bets.start = count_ - 1;
    bets.gain = std::max(0.0, bets.gain + log_bet);
  }
}

double PowerMartingale::LogEvidence() const {
  // What is kept for the starts to come.
  double log_evidence = std::log(WeightAfter(count_));
  const double log_share = -std::log(static_cast<double>(bets_.size()));
  for (const Bets& bets : bets_) log_evidence = LogOfSum(log_evidence, bets.log_sum + log_share);
  return log_evidence;
}

std::int64_t PowerMartingale::LikelyStart() const {
  return std::max_element(bets_.begin(), bets_.end(),
                          [](const Bets& first, const Bets& second) { return first.gain < second.gain; })
      ->start;
}

}  // namespace contact_shapelets::core
