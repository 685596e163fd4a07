#include "core/model/cluster_names.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace contact_shapelets::core {
namespace {

using Names = std::vector<std::string>;

Eigen::VectorXi Labels(const std::vector<int>& values) {
  return Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(NameClusters, GivesEachClusterItsOutcome) {
  EXPECT_EQ(NameClusters(Labels({0, 0, 1, 1, 2}), {"b", "b", "a", "a", "c"}, 3), (Names{"b", "a", "c"}));
}

TEST(NameClusters, MaximisesTheItemsNamedRightOverAllClusters) {
  // Each cluster alone would take "a". Cluster 1 as "a" and 0 as "b" makes 4 + 3 right, cluster 0 as "a" only 4 + 0.
  const Names outcomes = {"a", "a", "a", "a", "b", "b", "b", "a", "a", "a", "a"};
  EXPECT_EQ(NameClusters(Labels({0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1}), outcomes, 2), (Names{"b", "a"}));
}

TEST(NameClusters, DoNotGiveAClusterTheNameOfARareOutcomeThatItHardlyHolds) {
  const Names outcomes = {"a", "a", "a", "a", "a", "a", "a", "rare", "rare"};
  EXPECT_EQ(NameClusters(Labels({0, 0, 1, 1, 1, 1, 1, 1, 1}), outcomes, 2), (Names{"a", "a"}));
  EXPECT_EQ(NameClusters(Labels({0, 0, 0, 1, 1, 1, 1, 1, 1}), outcomes, 2), (Names{"a", "rare"}));
}

TEST(NameClusters, IgnoresItemsWithoutAnOutcome) {
  EXPECT_EQ(NameClusters(Labels({0, 0, 0, 1}), {"", "", "a", "b"}, 2), (Names{"a", "b"}));
}

TEST(NameClusters, LeavesAClusterUnnamedThatSharesNoItemWithAnOutcome) {
  EXPECT_EQ(NameClusters(Labels({0, 0, 1}), {"a", "b", ""}, 2)[1], "");
  EXPECT_EQ(NameClusters(Labels({0, 0}), {"a", "a"}, 3), (Names{"a", "", ""}));
}

TEST(NameClusters, GivesALeftOverClusterTheOutcomeOfMostOfItsItems) {
  EXPECT_EQ(NameClusters(Labels({0, 0, 0, 1, 1}), {"a", "a", "a", "a", "a"}, 2), (Names{"a", "a"}));
}

TEST(NameClusters, LeavesALeftOverClusterUnnamedWithoutAMajority) {
  const Names outcomes = {"a", "a", "a", "b", "b", "b", "a", "b"};
  EXPECT_EQ(NameClusters(Labels({0, 0, 0, 1, 1, 1, 2, 2}), outcomes, 3), (Names{"a", "b", ""}));
}

TEST(NameClusters, NamesNothingWithoutOutcomes) {
  EXPECT_EQ(NameClusters(Labels({0, 1}), {"", ""}, 2), (Names{"", ""}));
  EXPECT_EQ(NameClusters(Labels({}), {}, 2), (Names{"", ""}));
}

TEST(NameClusters, RefusesFaultyInput) {
  EXPECT_THROW(NameClusters(Labels({0, 1}), {"a"}, 2), std::invalid_argument);
  EXPECT_THROW(NameClusters(Labels({0, 2}), {"a", "b"}, 2), std::invalid_argument);
  EXPECT_THROW(NameClusters(Labels({0, -1}), {"a", "b"}, 2), std::invalid_argument);
  EXPECT_THROW(NameClusters(Labels({0, 2}), {"", ""}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
