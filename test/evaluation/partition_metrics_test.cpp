#include "evaluation/partition_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::evaluation {
namespace {

Eigen::VectorXi Labels(const std::vector<int>& values) {
  return Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size()));
}

PartitionScores Scores(const std::vector<int>& labels, const std::vector<int>& classes) {
  return ComparePartitions(Labels(labels), Labels(classes));
}

std::vector<int> RandomLabels(int count, int different, core::Random* random) {
  std::vector<int> labels(static_cast<std::size_t>(count));
  for (int& label : labels) label = random->Index(different);
  return labels;
}

TEST(ComparePartitions, EqualPartitionsScoreOneWhateverTheirNumbers) {
  const PartitionScores scores = Scores({5, 5, 0, 0, 3}, {1, 1, 2, 2, 0});
  EXPECT_DOUBLE_EQ(scores.rand_index, 1.0);
  EXPECT_DOUBLE_EQ(scores.adjusted_rand_index, 1.0);
  EXPECT_NEAR(scores.normalised_mutual_information, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(scores.accuracy, 1.0);
}

TEST(ComparePartitions, MatchesAHandComputedCase) {
  // Table [[2, 1], [0, 3]]: 15 pairs, together 1 + 3 = 4, in clusters 3 + 3 = 6, in classes 1 + 6 = 7.
  const PartitionScores scores = Scores({0, 0, 0, 1, 1, 1}, {0, 0, 1, 1, 1, 1});
  EXPECT_NEAR(scores.rand_index, (15.0 + 8.0 - 6.0 - 7.0) / 15.0, 1e-12);
  EXPECT_NEAR(scores.adjusted_rand_index, (4.0 - 42.0 / 15.0) / (6.5 - 42.0 / 15.0), 1e-12);
  EXPECT_NEAR(scores.accuracy, 5.0 / 6.0, 1e-12);
  const double clusters = std::log(2.0);
  const double classes = -(std::log(1.0 / 3.0) / 3.0 + 2.0 * std::log(2.0 / 3.0) / 3.0);
  const double joint = -(std::log(1.0 / 3.0) / 3.0 + std::log(1.0 / 6.0) / 6.0 + std::log(0.5) / 2.0);
  EXPECT_NEAR(scores.normalised_mutual_information, (clusters + classes - joint) / (0.5 * (clusters + classes)), 1e-12);
}

TEST(ComparePartitions, RandIndexCountsPairsGroupedAlike) {
  core::Random random(1);
  for (int round = 0; round < 20; ++round) {
    const std::vector<int> labels = RandomLabels(25, 4, &random);
    const std::vector<int> classes = RandomLabels(25, 3, &random);
    int alike = 0;
    for (std::size_t one = 0; one < 25; ++one) {
      for (std::size_t other = one + 1; other < 25; ++other) {
        alike += (labels[one] == labels[other]) == (classes[one] == classes[other]) ? 1 : 0;
      }
    }
    EXPECT_NEAR(Scores(labels, classes).rand_index, alike / 300.0, 1e-12);
  }
}

TEST(ComparePartitions, OneClusterAgainstManyClassesSaysNothing) {
  const PartitionScores scores = Scores({0, 0, 0, 0}, {0, 1, 0, 1});
  EXPECT_NEAR(scores.rand_index, 2.0 / 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(scores.adjusted_rand_index, 0.0);
  EXPECT_NEAR(scores.normalised_mutual_information, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(scores.accuracy, 0.5);
}

TEST(ComparePartitions, IndependentPartitionsHaveNoMutualInformation) {
  const PartitionScores scores = Scores({0, 0, 1, 1}, {0, 1, 0, 1});
  EXPECT_NEAR(scores.normalised_mutual_information, 0.0, 1e-12);
  EXPECT_NEAR(scores.adjusted_rand_index, -0.5, 1e-12);
}

TEST(ComparePartitions, TrivialPartitionsThatAgreeScoreOne) {
  for (const std::vector<int>& partition : {std::vector<int>{0, 0, 0}, std::vector<int>{0, 1, 2}}) {
    const PartitionScores scores = Scores(partition, partition);
    EXPECT_DOUBLE_EQ(scores.rand_index, 1.0);
    EXPECT_DOUBLE_EQ(scores.adjusted_rand_index, 1.0);
    EXPECT_NEAR(scores.normalised_mutual_information, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(scores.accuracy, 1.0);
  }
}

TEST(ComparePartitions, IsSymmetricAndBlindToTheNumbersOfClusters) {
  core::Random random(2);
  for (int round = 0; round < 20; ++round) {
    const std::vector<int> labels = RandomLabels(40, 5, &random);
    const std::vector<int> classes = RandomLabels(40, 3, &random);
    const std::vector<int> renumbered_as = random.Sample(9, 5);
    std::vector<int> renumbered;
    for (const int label : labels) renumbered.push_back(renumbered_as[static_cast<std::size_t>(label)]);
    const PartitionScores scores = Scores(labels, classes);
    for (const PartitionScores& other : {Scores(classes, labels), Scores(renumbered, classes)}) {
      EXPECT_NEAR(other.rand_index, scores.rand_index, 1e-12);
      EXPECT_NEAR(other.adjusted_rand_index, scores.adjusted_rand_index, 1e-12);
      EXPECT_NEAR(other.normalised_mutual_information, scores.normalised_mutual_information, 1e-12);
      EXPECT_NEAR(other.accuracy, scores.accuracy, 1e-12);
    }
  }
}

TEST(ComparePartitions, AdjustedRandIndexOfChanceIsNearZero) {
  core::Random random(3);
  double sum = 0.0;
  for (int round = 0; round < 200; ++round) {
    sum += Scores(RandomLabels(60, 3, &random), RandomLabels(60, 3, &random)).adjusted_rand_index;
  }
  EXPECT_NEAR(sum / 200.0, 0.0, 0.01);
}

TEST(ComparePartitions, FewerThanTwoItemsAgreeWholly) {
  EXPECT_EQ(Scores({}, {}).rand_index, 1.0);
  EXPECT_EQ(Scores({3}, {1}).accuracy, 1.0);
}

TEST(ComparePartitions, RefusesFaultyInput) {
  EXPECT_THROW(Scores({0, 1}, {0}), std::invalid_argument);
  EXPECT_THROW(Scores({0, -1}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(Scores({0, 0}, {0, -1}), std::invalid_argument);
  EXPECT_THROW(Scores({-1}, {0}), std::invalid_argument);
}

TEST(CompareWithOutcomes, ComparesThoseThatHaveOne) {
  std::vector<core::Episode> episodes(5);
  episodes[0].outcome = "on";
  episodes[2].outcome = "off";
  episodes[3].outcome = "on";
  const Eigen::VectorXi labels = (Eigen::VectorXi(5) << 1, 1, 0, 0, 1).finished();
  const auto agreement = CompareWithOutcomes(labels, episodes);
  ASSERT_TRUE(agreement);
  EXPECT_EQ(agreement->episodes, 3U);
  // Only the first of the three pairs is grouped alike.
  EXPECT_NEAR(agreement->scores.rand_index, 1.0 / 3.0, 1e-12);
}

TEST(CompareWithOutcomes, ReturnsNothingIfFewerThanTwoHaveOne) {
  std::vector<core::Episode> episodes(3);
  episodes[1].outcome = "on";
  EXPECT_FALSE(CompareWithOutcomes(Eigen::VectorXi::Zero(3), episodes));
  EXPECT_THROW(CompareWithOutcomes(Eigen::VectorXi::Zero(2), episodes), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
