#include "core/clustering/consensus.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

/// Returns six noisy features. Each of them tells `groups` apart.
View GroupedView(const Eigen::Ref<const Eigen::VectorXi>& groups, int voters, std::uint64_t seed) {
  constexpr int kFeatures = 6;
  Random random(seed);
  View view{Eigen::MatrixXf(groups.size(), kFeatures), Eigen::VectorXf::Ones(kFeatures), voters};
  for (Eigen::Index row = 0; row < groups.size(); ++row) {
    for (int column = 0; column < kFeatures; ++column) {
      view.features(row, column) = static_cast<float>(10.0 * groups[row] + 0.1 * random.Normal());
    }
  }
  return view;
}

/// Returns features that tell nothing apart.
View NoiseView(int count, int voters, std::uint64_t seed) {
  return GroupedView(Eigen::VectorXi::Zero(count), voters, seed);
}

Eigen::VectorXi Alternating(int count) {
  Eigen::VectorXi groups(count);
  for (int index = 0; index < count; ++index) groups[index] = index % 2;
  return groups;
}

/// Returns groups that are independent of Alternating().
Eigen::VectorXi Halves(int count) {
  Eigen::VectorXi groups(count);
  for (int index = 0; index < count; ++index) groups[index] = index < count / 2 ? 0 : 1;
  return groups;
}

ConsensusOptions TwoClusters() {
  ConsensusOptions options;
  options.clusters = 2;
  options.seed = 5;
  return options;
}

TEST(Consensus, FollowsTheMajorityOfVoters) {
  const std::vector<View> views{GroupedView(Alternating(40), 20, 1), GroupedView(Halves(40), 8, 2)};
  EXPECT_EQ(ConsensusLabels(views, TwoClusters(), 1), Alternating(40));
}

TEST(Consensus, IsNotSwayedByAsManyVotersThatSeeNoise) {
  const std::vector<View> views{GroupedView(Alternating(40), 20, 3), NoiseView(40, 20, 4)};
  EXPECT_EQ(ConsensusLabels(views, TwoClusters(), 1), Alternating(40));
}

TEST(Consensus, WeighsColumnsOfSmallScaleMore) {
  // Columns of small scale follow Alternating(). The others follow Halves() and are larger by half.
  View view = GroupedView(Alternating(40), 40, 6);
  const View other = GroupedView(Halves(40), 0, 7);
  view.features.rightCols(3) = 1.5F * other.features.rightCols(3);
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), 1), Halves(40));
  view.scales.head(3).setConstant(0.01F);
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), 1), Alternating(40));
}

TEST(Consensus, DoesNotDependOnTheNumberOfThreads) {
  const View view = NoiseView(50, 15, 8);
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), 1), ConsensusLabels({view}, TwoClusters(), 3));
}

TEST(Consensus, TakesAnyNumberOfThreads) {
  const View view = NoiseView(20, 15, 8);
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), std::numeric_limits<int>::max()),
            ConsensusLabels({view}, TwoClusters(), 1));
}

TEST(Consensus, ReportsProgressAndEndsIfTheCallbackThrows) {
  const View view = NoiseView(20, 15, 8);
  double done = 0.0;
  ConsensusLabels({view}, TwoClusters(), 2, [&done](double part) {
    EXPECT_GT(part, done);
    done = part;
  });
  EXPECT_EQ(done, 1.0);
  EXPECT_THROW(ConsensusLabels({view}, TwoClusters(), 2, [](double) { throw std::runtime_error("no more"); }),
               std::runtime_error);
}

TEST(Consensus, WeighsAllColumnsAlikeIfTheGreatestExponentIsZero) {
  View view = GroupedView(Alternating(40), 40, 6);
  view.features.rightCols(3) = 1.5F * GroupedView(Halves(40), 0, 7).features.rightCols(3);
  view.scales.head(3).setConstant(0.01F);
  view.greatest_exponent = 0.0;
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), 1), Halves(40));
}

TEST(Consensus, SplitsAsManySeriesAsClusters) {
  EXPECT_EQ(ConsensusLabels({GroupedView(Alternating(2), 9, 9)}, TwoClusters(), 1), Alternating(2));
}

TEST(Consensus, RefusesViewsThatDoNotMatch) {
  EXPECT_THROW(ConsensusLabels({NoiseView(4, 1, 1), NoiseView(5, 1, 1)}, TwoClusters(), 1), std::invalid_argument);
  View view = NoiseView(4, 1, 1);
  view.scales = Eigen::VectorXf::Ones(2);
  EXPECT_THROW(ConsensusLabels({view}, TwoClusters(), 1), std::invalid_argument);
}

TEST(Consensus, NeedsAVoter) {
  EXPECT_THROW(ConsensusLabels({}, TwoClusters(), 1), std::invalid_argument);
  EXPECT_THROW(ConsensusLabels({NoiseView(4, 0, 1)}, TwoClusters(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
