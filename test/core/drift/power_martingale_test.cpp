#include "core/drift/power_martingale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

double Uniform(Random* random) { return 1.0 - random->Uniform(); }

TEST(PowerMartingale, StartsWithoutEvidence) { EXPECT_DOUBLE_EQ(PowerMartingale().LogEvidence(), 0.0); }

TEST(PowerMartingale, HasTheAnalyticEvidenceAfterOnePValue) {
  PowerMartingale martingale;
  martingale.Append(0.25);
  double bets = 0.0;
  for (const double exponent : {0.1, 0.3, 0.5, 0.7, 0.9}) bets += exponent * std::pow(0.25, exponent - 1.0) / 5.0;
  // What is not bet on the first p-value is kept for later starts.
  const double kept = std::log(2.0) / std::log(3.0);
  EXPECT_NEAR(martingale.LogEvidence(), std::log((1.0 - kept) * bets + kept), 1e-12);
}

TEST(PowerMartingale, PassesItsLimitNoMoreOftenThanStated) {
  constexpr int kRuns = 1000;
  int passed = 0;
  Random random(7);
  for (int run = 0; run < kRuns; ++run) {
    PowerMartingale martingale;
    bool passes = false;
    for (int episode = 0; episode < 500 && !passes; ++episode) {
      martingale.Append(Uniform(&random));
      passes = martingale.LogEvidence() > std::log(1.0 / 0.1);
    }
    passed += passes ? 1 : 0;
  }
  EXPECT_LE(passed, 0.1 * kRuns);
}

TEST(PowerMartingale, FindsAChangeAfterALongTimeAndWhereItBegan) {
  Random random(3);
  PowerMartingale martingale;
  for (int episode = 0; episode < 1000; ++episode) martingale.Append(Uniform(&random));
  int needed = 0;
  for (; martingale.LogEvidence() < std::log(1000.0) && needed < 100; ++needed) {
    martingale.Append(0.02 * Uniform(&random));
  }
  EXPECT_LT(needed, 20);
  EXPECT_NEAR(static_cast<double>(martingale.LikelyStart()), 1000.0, 5.0);
}

TEST(PowerMartingale, StaysFiniteWithTheSmallestPValues) {
  PowerMartingale martingale;
  for (int episode = 0; episode < 10'000; ++episode) martingale.Append(1e-12);
  EXPECT_TRUE(std::isfinite(martingale.LogEvidence()));
  EXPECT_EQ(martingale.LikelyStart(), 0);
}

}  // namespace
}  // namespace contact_shapelets::core
