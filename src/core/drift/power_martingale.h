#pragma once

#include <array>
#include <cstdint>

/// \file
/// Bets against the hypothesis that p-values are uniform. Its evidence passes 1 / alpha with a probability of at most
/// alpha, however long it is watched (Ville 1939).

namespace contact_shapelets::core {

/// A mixture of power martingales (Vovk, Nouretdinov and Gammerman 2003) over exponents, and over the p-value at which
/// the bets begin, so that a change is found soon after a long time without one. Bets on small p-values.
class PowerMartingale {
 public:
  /// Takes the next p-value, in (0, 1]; under the hypothesis it is uniform and independent of the earlier ones.
  void Append(double p_value);

  /// Returns the natural logarithm of the evidence, which starts at 0.
  double LogEvidence() const;

  /// Returns how many p-values came before the likely change: those before the start of the bets that gained most.
  std::int64_t LikelyStart() const;

 private:
  /// The bets with one exponent.
  struct Bets {
    double log_sum = -1e300;  ///< logarithm of the weighed sum over all starts
    double gain = 0.0;        ///< logarithm of what the best start gained, at least 0
    std::int64_t start = 0;   ///< p-values before that start
  };
  static constexpr std::array<double, 5> kExponents{0.1, 0.3, 0.5, 0.7, 0.9};

  std::array<Bets, kExponents.size()> bets_;
  std::int64_t count_ = 0;
};

}  // namespace contact_shapelets::core
