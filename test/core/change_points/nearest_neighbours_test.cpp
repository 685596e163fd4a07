#include "core/change_points/nearest_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/change_points/neighbours_by_definition.h"
#include "core/change_points/planted_changes.h"

namespace contact_shapelets::core {
namespace {

Subsequences AllOf(const Eigen::VectorXd& series, int window) {
  Subsequences subsequences(window);
  for (Eigen::Index index = 0; index < series.size(); ++index) subsequences.Append(series[index]);
  return subsequences;
}

class NearestNeighboursOfRandomSeries : public testing::TestWithParam<int> {};

TEST_P(NearestNeighboursOfRandomSeries, AreThoseOfTheDefinition) {
  const int size = GetParam();
  Random random(size);
  const Eigen::VectorXd series = Noise(size, &random);
  const int window = 7;
  const int count = size - window + 1;
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, window), 0, count, 4);
  ASSERT_EQ(table.size(), count);
  for (int i = 0; i < count; ++i) {
    const auto expected = NearestByDefinition(series, i, count, window, 4);
    for (int place = 0; place < 4; ++place) {
      EXPECT_NEAR(table.Correlations(i)[place], expected[place], 2.0 * kTie);
      EXPECT_NEAR(CorrelationByDefinition(series, i, table.Neighbours(i)[place], window), expected[place], 2.0 * kTie);
    }
  }
}

// Counts of diagonals that do and do not fill the lanes.
INSTANTIATE_TEST_SUITE_P(Sizes, NearestNeighboursOfRandomSeries, testing::Values(20, 25, 26, 27, 33, 100, 101, 150));

TEST(NearestNeighbours, ShareAtMostHalfOfTheirSamples) {
  Random random(1);
  const Eigen::VectorXd series = Sine(300, 60.0, &random);
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, 20), 0, 281, 3);
  for (int i = 0; i < table.size(); ++i) {
    for (const int neighbour : table.Neighbours(i)) EXPECT_GT(std::abs(neighbour - i), 10);
  }
}

TEST(NearestNeighbours, OfAPartAreWithinIt) {
  Random random(2);
  const Eigen::VectorXd series = Noise(120, &random);
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, 8), 30, 50, 2);
  ASSERT_EQ(table.size(), 50);
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd part = series.segment(30, 57);
    const auto expected = NearestByDefinition(part, i, 50, 8, 2);
    EXPECT_NEAR(table.Correlations(i)[1], expected[1], 2.0 * kTie);
    EXPECT_NEAR(CorrelationByDefinition(part, i, table.Neighbours(i)[1], 8), expected[1], 2.0 * kTie);
  }
}

TEST(NearestNeighbours, AreIndependentOfAnOffset) {
  Random random(3);
  const Eigen::VectorXd series = Noise(400, &random);
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, 12), 0, 389, 3);
  const NeighbourTable far = FindNearestNeighbours(AllOf((series.array() + 1e7).matrix(), 12), 0, 389, 3);
  for (int i = 0; i < table.size(); ++i) EXPECT_EQ(far.Neighbours(i), table.Neighbours(i));
}

TEST(NearestNeighbours, AreAnywhereInASeriesThatRepeatsItself) {
  Eigen::VectorXd series(4000);
  for (int index = 0; index < series.size(); ++index) series[index] = index * index % 37;
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, 12), 0, 3989, 1);
  double lag = 0.0;
  for (int i = 0; i < table.size(); ++i) lag += std::abs(table.Neighbours(i)[0] - i) / 3989.0;
  // A third of the length between two places at random.
  EXPECT_NEAR(lag, 3989 / 3.0, 200.0);
}

TEST(NearestNeighbours, OfNoiseAreNotFlat) {
  Random random(4);
  const Eigen::VectorXd series = Concatenated({Noise(200, &random), Eigen::VectorXd::Constant(200, 3.0)});
  const NeighbourTable table = FindNearestNeighbours(AllOf(series, 10), 0, 391, 3);
  for (int i = 0; i < 190; ++i) {
    for (const int neighbour : table.Neighbours(i)) EXPECT_LT(neighbour, 200);
  }
}

TEST(Subsequences, AreFlatWhereTheSeriesIsConstantToRounding) {
  Random random(5);
  Eigen::VectorXd series = Concatenated({Eigen::VectorXd::Constant(20, 0.1), Eigen::VectorXd::Constant(20, 1e6)});
  series[35] += 1e-9;
  const Subsequences subsequences = AllOf(series, 8);
  for (int i = 0; i < subsequences.size(); ++i) EXPECT_EQ(subsequences.IsFlat(i), i <= 12 || i >= 20) << i;
}

TEST(CorrectVotesOfFlatOnes, LetsAllFlatOnesVote) {
  Eigen::VectorXd series = Eigen::VectorXd::LinSpaced(30, 0.0, 1.0);
  series.segment(3, 4).setConstant(0.7);    // flat with windows of 3: 3 and 4
  series.segment(20, 6).setConstant(-0.7);  // 20 to 23
  std::vector<int> votes(26, 5);
  CorrectVotesOfFlatOnes(AllOf(series, 3), 2, &votes);
  std::vector<int> expected(26, 5);
  for (const int flat : {3, 4, 20, 21, 22, 23}) expected[flat - 2] = 21 - 2;
  EXPECT_EQ(votes, expected);
}

TEST(NearestNeighbours, AreMissingWhereTheSeriesIsTooShort) {
  const NeighbourTable table = FindNearestNeighbours(AllOf(Eigen::VectorXd::LinSpaced(17, 0.0, 1.0), 10), 0, 8, 3);
  std::vector<int> first = table.Neighbours(0);
  std::sort(first.begin(), first.end());
  EXPECT_EQ(first, (std::vector<int>{-1, 6, 7}));
  EXPECT_EQ(table.Neighbours(3), (std::vector<int>{-1, -1, -1}));
}

TEST(NeighbourTable, VotesForTheNeighbourInTheMiddle) {
  NeighbourTable table(3);
  for (int row = 0; row < 10; ++row) table.AppendRow();
  table.Offer(9, 0.7, 5);
  table.Offer(9, 0.9, 8);
  table.Offer(9, 0.8, 2);
  EXPECT_EQ(table.Votes(0)[9], 5);
  EXPECT_EQ(table.Votes(0)[8], -1);
}

TEST(NeighbourTable, GivesForgottenNeighboursNoVote) {
  NeighbourTable table(3);
  for (int row = 0; row < 10; ++row) table.AppendRow();
  table.Offer(9, 0.7, 5);
  table.Offer(9, 0.9, 8);
  table.Offer(9, 0.8, 2);
  // 5 and 8 remain; the more similar one decides.
  EXPECT_EQ(table.Votes(3)[9 - 3], 8 - 3);
  EXPECT_EQ(table.Votes(9)[0], -1);
  table.EraseFirst(3);
  EXPECT_EQ(table.Votes(0)[6], 5);
}

TEST(NeighbourTable, KeepsTheMostSimilar) {
  NeighbourTable table(2);
  for (int row = 0; row < 5; ++row) table.AppendRow();
  table.Offer(0, 0.1, 1);
  table.Offer(0, 0.3, 2);
  table.Offer(0, 0.2, 3);
  table.Offer(0, 0.2, 4);
  EXPECT_EQ(table.Neighbours(0), (std::vector<int>{2, 3}));
  EXPECT_EQ(table.Correlations(0), (std::vector<double>{0.3, 0.2}));
}

TEST(NeighbourTable, VotesForTheMiddleOfFive) {
  NeighbourTable table(5);
  for (int row = 0; row < 10; ++row) table.AppendRow();
  for (const int neighbour : {6, 1, 9, 3, 2}) table.Offer(0, 0.5, neighbour);
  EXPECT_EQ(table.Votes(0)[0], 3);
}

}  // namespace
}  // namespace contact_shapelets::core
