#include "contact_shapelets/core/consensus.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "contact_shapelets/core/random.h"

namespace contact_shapelets::core {
namespace {

/// A view of `groups`, one point per series at 10 times its group, with noise.
View GroupedView(const Eigen::Ref<const Eigen::VectorXi>& groups, std::uint64_t seed) {
  Random random(seed);
  View view(groups.size(), 2);
  for (Eigen::Index row = 0; row < groups.size(); ++row) {
    view.row(row) << static_cast<float>(10.0 * groups[row] + 0.1 * random.Normal()),
        static_cast<float>(random.Normal());
  }
  return view;
}

Eigen::VectorXi Alternating(int count) {
  Eigen::VectorXi groups(count);
  for (int index = 0; index < count; ++index) groups[index] = index % 2;
  return groups;
}

/// Groups that have nothing to do with Alternating().
Eigen::VectorXi Halves(int count) {
  Eigen::VectorXi groups(count);
  for (int index = 0; index < count; ++index) groups[index] = index < count / 2 ? 0 : 1;
  return groups;
}

KMeansOptions TwoClusters() {
  KMeansOptions options;
  options.clusters = 2;
  options.seed = 5;
  return options;
}

TEST(Consensus, FollowsTheMajorityAgainstAViewThatDisagrees) {
  const std::vector<View> views{GroupedView(Alternating(40), 1), GroupedView(Halves(40), 2),
                                GroupedView(Alternating(40), 3)};
  EXPECT_EQ(ConsensusLabels(views, TwoClusters(), 1), Alternating(40));
}

TEST(Consensus, ASingleViewDecidesAlone) {
  const View view = GroupedView(Alternating(30), 4);
  EXPECT_EQ(ConsensusLabels({view}, TwoClusters(), 1), Alternating(30));
}

TEST(Consensus, DoesNotDependOnTheNumberOfThreads) {
  std::vector<View> views;
  for (std::uint64_t seed = 0; seed < 5; ++seed) views.push_back(Eigen::MatrixXf::Random(50, 3));
  EXPECT_EQ(ConsensusLabels(views, TwoClusters(), 1), ConsensusLabels(views, TwoClusters(), 3));
}

TEST(Consensus, RefusesViewsOfDifferentSeries) {
  EXPECT_THROW(ConsensusLabels({View::Zero(4, 2), View::Zero(5, 2)}, TwoClusters(), 1), std::invalid_argument);
  EXPECT_THROW(ConsensusLabels({}, TwoClusters(), 1), std::invalid_argument);
}

TEST(ScaleViews, WeighEachFeatureByAPowerOfItsScale) {
  const Eigen::MatrixXf features = Eigen::MatrixXf::Ones(3, 2);
  const std::vector<View> views = ScaleViews(features, Eigen::Vector2f(0.25F, 1.0F), {0.0, 0.5, 1.0});
  ASSERT_EQ(views.size(), 3U);
  EXPECT_TRUE(views[0].isApprox(features));
  EXPECT_NEAR(views[1](2, 0), 2.0, 1e-6);
  EXPECT_NEAR(views[2](2, 0), 4.0, 1e-6);
  EXPECT_NEAR(views[2](2, 1), 1.0, 1e-6);
}

TEST(ScaleViews, NeedOneScaleForEachFeature) {
  EXPECT_THROW(ScaleViews(Eigen::MatrixXf::Ones(3, 2), Eigen::Vector3f::Ones(), {0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
