#include "core/change_points/sliding_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/change_points/nearest_neighbours.h"
#include "core/change_points/neighbours_by_definition.h"
#include "core/change_points/planted_changes.h"

namespace contact_shapelets::core {
namespace {

constexpr int kWindow = 9;

SlidingNeighbours After(const Eigen::VectorXd& series, int sliding_window) {
  SlidingNeighbours neighbours(kWindow, 3, sliding_window);
  for (Eigen::Index index = 0; index < series.size(); ++index) neighbours.Append(series[index]);
  return neighbours;
}

std::vector<std::vector<int>> Offline(const Eigen::VectorXd& series) {
  Subsequences subsequences(kWindow);
  for (Eigen::Index index = 0; index < series.size(); ++index) subsequences.Append(series[index]);
  const NeighbourTable table = FindNearestNeighbours(subsequences, 0, subsequences.size(), 3);
  std::vector<std::vector<int>> all;
  for (int i = 0; i < table.size(); ++i) all.push_back(table.Neighbours(i));
  return all;
}

/// Whether all neighbours that are not missing are among the nearest of the series.
testing::AssertionResult AreNearest(const std::vector<std::vector<int>>& neighbours, const Eigen::VectorXd& series) {
  const int count = static_cast<int>(neighbours.size());
  for (int i = 0; i < count; ++i) {
    const double farthest = NearestByDefinition(series, i, count, kWindow, 3).back();
    for (const int neighbour : neighbours[i]) {
      if (neighbour == -1) continue;
      if (CorrelationByDefinition(series, i, neighbour, kWindow) < farthest - 2.0 * kTie) {
        return testing::AssertionFailure() << neighbour << " is no neighbour of " << i;
      }
    }
  }
  return testing::AssertionSuccess();
}

int CountMissing(const std::vector<std::vector<int>>& neighbours) {
  int missing = 0;
  for (const auto& row : neighbours) missing += static_cast<int>(std::count(row.begin(), row.end(), -1));
  return missing;
}

TEST(SlidingNeighbours, AreThoseOfTheWholeSeriesWhileItFitsIntoTheSlidingWindow) {
  Random random(1);
  const Eigen::VectorXd series = Noise(500, &random);
  const SlidingNeighbours sliding = After(series, 500);
  EXPECT_EQ(sliding.size(), 500);
  EXPECT_EQ(sliding.Neighbours(), Offline(series));
}

TEST(SlidingNeighbours, KeepTheSamplesOfTheSlidingWindow) {
  Random random(2);
  const SlidingNeighbours sliding = After(Noise(1234, &random), 300);
  EXPECT_EQ(sliding.size(), 300);
  EXPECT_EQ(sliding.Neighbours().size(), 300U - kWindow + 1);
}

TEST(SlidingNeighbours, AreThoseOfTheSlidingWindowButForThoseThatLeftIt) {
  Random random(3);
  const Eigen::VectorXd series = Noise(1500, &random);
  const auto neighbours = After(series, 400).Neighbours();
  EXPECT_TRUE(AreNearest(neighbours, series.tail(400)));
  // Of places at random within the window when each came, 1 - ln 2 of all have left.
  EXPECT_NEAR(CountMissing(neighbours) / (3.0 * static_cast<double>(neighbours.size())), 0.31, 0.06);
}

TEST(SlidingNeighbours, ForgetWhatTheyAreToldTo) {
  Random random(4);
  const Eigen::VectorXd series = Noise(400, &random);
  SlidingNeighbours sliding = After(series, 400);
  const auto before = sliding.Votes();
  sliding.Forget(150);
  EXPECT_EQ(sliding.size(), 250);
  ASSERT_EQ(sliding.Votes().size(), 250U - kWindow + 1);
  for (const int vote : sliding.Votes()) EXPECT_LT(vote, 250);
}

TEST(SlidingNeighbours, FindNewSamplesAfterForgetting) {
  Random random(5);
  const Eigen::VectorXd first = Noise(400, &random);
  const Eigen::VectorXd second = Noise(300, &random);
  SlidingNeighbours sliding = After(first, 1000);
  sliding.Forget(400 - kWindow + 1);  // what remains is shorter than a subsequence
  for (Eigen::Index index = 0; index < second.size(); ++index) sliding.Append(second[index]);
  EXPECT_TRUE(AreNearest(sliding.Neighbours(), Concatenated({first.tail(kWindow - 1), second})));
  EXPECT_EQ(CountMissing(sliding.Neighbours()), 0);
}

TEST(SlidingNeighbours, RecoverFromAGlitch) {
  Random random(6);
  Eigen::VectorXd series = Noise(2000, &random);
  const auto expected = After(series, 200).Neighbours();
  series[500] = 1e9;
  EXPECT_EQ(After(series, 200).Neighbours(), expected);
}

TEST(SlidingNeighbours, LetFlatOnesVoteForTheMiddleOfAllThatAreFlat) {
  SlidingNeighbours sliding = After(Eigen::VectorXd::Constant(300, 2.5), 300);
  EXPECT_EQ(sliding.Votes(), std::vector<int>(292, 146));
  sliding.Forget(100);
  EXPECT_EQ(sliding.Votes(), std::vector<int>(192, 96));
}

}  // namespace
}  // namespace contact_shapelets::core
