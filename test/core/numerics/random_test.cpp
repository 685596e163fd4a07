#include "core/numerics/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace contact_shapelets::core {
namespace {

TEST(Random, EqualSeedsGiveEqualSequences) {
  Random first(7);
  Random second(7);
  for (int draw = 0; draw < 100; ++draw) EXPECT_EQ(first.Uniform(), second.Uniform());
}

TEST(Random, DifferentSeedsGiveDifferentSequences) { EXPECT_NE(Random(7).Uniform(), Random(8).Uniform()); }

TEST(StreamSeed, DiffersBetweenStreamsAndSeeds) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint32_t stream = 0; stream < 20; ++stream) seeds.insert(StreamSeed(seed, stream));
  }
  EXPECT_EQ(seeds.size(), 400U);
  EXPECT_EQ(StreamSeed(3, 4), StreamSeed(3, 4));
  EXPECT_NE(StreamSeed(3, 4), StreamSeed(3 + (1ULL << 32U), 4));
}

TEST(StreamSeed, GivesSequencesThatDoNotCorrelate) {
  constexpr int kDraws = 4000;
  Random first(StreamSeed(0, 0));
  Random second(StreamSeed(0, 1));
  double product = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) product += (first.Uniform() - 0.5) * (second.Uniform() - 0.5);
  // Five standard deviations of the mean of independent products, each of deviation 1 / 12.
  EXPECT_LT(std::abs(product / kDraws), 5.0 / 12.0 / std::sqrt(kDraws));
}

TEST(Random, IsTheMersenneTwisterThatTheStandardFixes) {
  // [rand.predef]: the 10000th value of a default-seeded mt19937_64 is 9981545732273789042.
  Random random(5489);
  for (int draw = 1; draw < 10000; ++draw) random.Uniform();
  EXPECT_EQ(random.Uniform(), static_cast<double>(9981545732273789042ULL >> 11U) / 9007199254740992.0);
}

TEST(Random, UniformStaysWithinItsBoundsAndFillsThem) {
  Random random(1);
  double least = 5.0;
  double greatest = 2.0;
  double sum = 0.0;
  for (int draw = 0; draw < 20000; ++draw) {
    const double value = random.Uniform(2.0, 5.0);
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
  }
  EXPECT_GE(least, 2.0);
  EXPECT_LT(greatest, 5.0);
  EXPECT_NEAR(least, 2.0, 0.01);
  EXPECT_NEAR(greatest, 5.0, 0.01);
  EXPECT_NEAR(sum / 20000.0, 3.5, 0.03);
}

TEST(Random, IndexIsEvenOverAllIndices) {
  Random random(2);
  std::vector<int> counts(7, 0);
  for (int draw = 0; draw < 70000; ++draw) ++counts.at(static_cast<std::size_t>(random.Index(7)));
  // Six standard deviations of a binomial count.
  for (const int count : counts) EXPECT_NEAR(count, 10000, 6.0 * std::sqrt(70000.0 * (1.0 / 7.0) * (6.0 / 7.0)));
}

TEST(Random, NormalHasTheMomentsOfTheStandardNormal) {
  Random random(3);
  constexpr int kDraws = 100000;
  double moments[5] = {};
  for (int draw = 0; draw < kDraws; ++draw) {
    const double value = random.Normal();
    ASSERT_TRUE(std::isfinite(value));
    for (int order = 1; order <= 4; ++order) moments[order] += std::pow(value, order) / kDraws;
  }
  EXPECT_NEAR(moments[1], 0.0, 0.02);
  EXPECT_NEAR(moments[2], 1.0, 0.03);
  EXPECT_NEAR(moments[3], 0.0, 0.06);
  EXPECT_NEAR(moments[4], 3.0, 0.2);
}

TEST(Random, SampleHasNoRepetition) {
  Random random(4);
  for (int chosen = 0; chosen <= 20; ++chosen) {
    const std::vector<int> sample = random.Sample(20, chosen);
    const std::set<int> different(sample.begin(), sample.end());
    EXPECT_EQ(sample.size(), static_cast<std::size_t>(chosen));
    EXPECT_EQ(different.size(), sample.size());
    if (chosen > 0) {
      EXPECT_GE(*different.begin(), 0);
      EXPECT_LT(*different.rbegin(), 20);
    }
  }
}

TEST(Random, SampleTakesEveryIndexEquallyOften) {
  Random random(5);
  std::vector<int> counts(10, 0);
  for (int draw = 0; draw < 10000; ++draw) {
    for (const int index : random.Sample(10, 3)) ++counts.at(static_cast<std::size_t>(index));
  }
  for (const int count : counts) EXPECT_NEAR(count, 3000, 6.0 * std::sqrt(10000.0 * 0.3 * 0.7));
}

}  // namespace
}  // namespace contact_shapelets::core
