#include "core/change_points/classification_profile.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

/// The counts of a split by their definition.
SplitCounts CountsByDefinition(const std::vector<int>& votes, int window, int split) {
  SplitCounts counts;
  for (int index = 0; index < static_cast<int>(votes.size()); ++index) {
    if (votes[index] < 0) continue;
    const bool as_left = votes[index] < split;
    if (index >= split) {
      ++(as_left ? counts.right_as_left : counts.right_as_right);
    } else if (index + window <= split) {
      ++(as_left ? counts.left_as_left : counts.left_as_right);
    }
  }
  return counts;
}

TEST(ClassificationProfile, CountsTheVotesOfEverySplit) {
  Random random(1);
  std::vector<int> votes(60);
  for (int& vote : votes) vote = random.Index(61) - 1;
  const ClassificationProfile profile(votes, 5);
  for (int split = 0; split <= 60; ++split) {
    const SplitCounts counts = profile.Counts(split);
    const SplitCounts expected = CountsByDefinition(votes, 5, split);
    EXPECT_EQ(counts.left_as_left, expected.left_as_left) << split;
    EXPECT_EQ(counts.left_as_right, expected.left_as_right) << split;
    EXPECT_EQ(counts.right_as_left, expected.right_as_left) << split;
    EXPECT_EQ(counts.right_as_right, expected.right_as_right) << split;
  }
}

/// Votes of 40 subsequences, of which the first 25 have their neighbours among themselves.
std::vector<int> VotesOfTwoKinds() {
  std::vector<int> votes;
  for (int index = 0; index < 25; ++index) votes.push_back(7 * index % 25);
  for (int index = 0; index < 15; ++index) votes.push_back(25 + 7 * index % 15);
  return votes;
}

TEST(ClassificationProfile, IsBestWhereNeighboursAreOnTheSameSide) {
  const auto best = ClassificationProfile(VotesOfTwoKinds(), 3).Best(6);
  ASSERT_TRUE(best.has_value());
  EXPECT_EQ(best->index, 25);
  EXPECT_DOUBLE_EQ(best->score, 1.0);
}

TEST(ClassificationProfile, LeavesTheMarginOnBothSides) {
  // 42 samples: with a margin of 20, splits before the samples 20, 21 and 22.
  const ClassificationProfile profile(VotesOfTwoKinds(), 3);
  EXPECT_EQ(profile.Best(18)->index, 24);
  EXPECT_EQ(profile.Best(20)->index, 22);
  EXPECT_FALSE(profile.Best(22).has_value());
}

TEST(ClassificationProfile, IsBestAtTheFirstOfEqualSplits) {
  EXPECT_EQ(ClassificationProfile(std::vector<int>(40, -1), 3).Best(6)->index, 6);
}

TEST(MacroF1, IsTheMeanOfBothSides) {
  // F1 of left 2*6 / (2*6 + 2 + 1), of right 2*4 / (2*4 + 2 + 1).
  EXPECT_DOUBLE_EQ(MacroF1({6.0, 2.0, 1.0, 4.0}), 0.5 * (12.0 / 15.0 + 8.0 / 11.0));
}

TEST(MacroF1, IsZeroForASideThatIsEmpty) {
  EXPECT_DOUBLE_EQ(MacroF1({5.0, 0.0, 0.0, 0.0}), 0.5);
  EXPECT_DOUBLE_EQ(MacroF1({0.0, 0.0, 0.0, 0.0}), 0.0);
}

TEST(RankSumPValue, IsThatOfTheNormalApproximation) {
  // Ranks 15.5 and 45.5 are shared by 30 each. The left sum is 20 * 15.5 + 10 * 45.5 = 765, expected 30 * 30.5 = 915
  // +- 67.64.
  EXPECT_NEAR(RankSumPValue({20.0, 10.0, 10.0, 20.0}), 0.026578, 1e-6);
}

TEST(RankSumPValue, ShrinksWithTheNumberOfVotes) {
  EXPECT_GT(RankSumPValue({20.0, 10.0, 10.0, 20.0}), RankSumPValue({200.0, 100.0, 100.0, 200.0}));
  EXPECT_LT(RankSumPValue({200.0, 0.0, 0.0, 200.0}), 1e-60);
}

TEST(RankSumPValue, IsOneForVotesAgainstTheirOwnSideAndForEmptySides) {
  EXPECT_EQ(RankSumPValue({10.0, 200.0, 200.0, 10.0}), 1.0);
  EXPECT_EQ(RankSumPValue({100.0, 100.0, 50.0, 50.0}), 1.0);
  EXPECT_EQ(RankSumPValue({100.0, 0.0, 0.0, 0.0}), 1.0);
}

}  // namespace
}  // namespace contact_shapelets::core
