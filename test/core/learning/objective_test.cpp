#include "core/learning/objective.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/learning/membership.h"
#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

Eigen::MatrixXd RandomMatrix(int rows, int columns, std::uint64_t seed) {
  Random random(seed);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&random] { return random.Uniform(); });
}

/// Returns the central differences of `loss` by every entry of `point`.
Eigen::MatrixXd FiniteDifferences(const std::function<double(const Eigen::MatrixXd&)>& loss, Eigen::MatrixXd point) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd gradient(point.rows(), point.cols());
  for (Eigen::Index index = 0; index < point.size(); ++index) {
    const double value = point(index);
    point(index) = value + kStep;
    const double above = loss(point);
    point(index) = value - kStep;
    const double below = loss(point);
    point(index) = value;
    gradient(index) = (above - below) / (2.0 * kStep);
  }
  return gradient;
}

TEST(Membership, OfOneSeriesFollowsEquation4AndSumsToOne) {
  const Eigen::VectorXf memberships = Membership(Eigen::Vector3f(0.0F, 1.0F, 2.0F));
  EXPECT_NEAR(memberships.sum(), 1.0F, 1e-6F);
  EXPECT_NEAR(memberships[0], 6.0F / 11.0F, 1e-6F);
  EXPECT_NEAR(memberships[1], 3.0F / 11.0F, 1e-6F);
  EXPECT_NEAR(memberships[2], 2.0F / 11.0F, 1e-6F);
}

TEST(Membership, ComparesWithValuesComputedByHand) {
  Eigen::MatrixXd distances(1, 2);
  distances << 0.0, 1.0;
  const Eigen::MatrixXd membership = Membership(distances);
  EXPECT_NEAR(membership(0, 0), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(membership(0, 1), 1.0 / 3.0, 1e-12);
}

TEST(SpectralTerm, EqualsHalfTheWeightedSumOfSquaredDifferences) {
  const Eigen::MatrixXd membership = RandomMatrix(6, 4, 1);
  Eigen::MatrixXd weights = RandomMatrix(6, 6, 2);
  weights = (weights + weights.transpose()).eval();
  weights.diagonal().setZero();
  double expected = 0.0;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      expected += 0.5 * weights(i, j) * (membership.row(i) - membership.row(j)).squaredNorm();
    }
  }
  EXPECT_NEAR(SpectralTerm(membership, weights).value, expected, 1e-12);
}

TEST(SpectralTerm, GradientThroughTheMembershipMatchesFiniteDifferences) {
  const Eigen::MatrixXd distances = RandomMatrix(7, 5, 3);
  const Eigen::MatrixXd similarity = GaussianSimilarity(SquaredDistances(RandomMatrix(7, 9, 4).cast<float>()));
  const Eigen::MatrixXd weights = ContrastiveWeights(similarity, 3.0);
  const auto loss = [&weights](const Eigen::MatrixXd& f) { return SpectralTerm(Membership(f), weights).value; };
  const Eigen::MatrixXd membership = Membership(distances);
  const Eigen::MatrixXd analytic = DistanceGradient(distances, membership, SpectralTerm(membership, weights).gradient);
  EXPECT_LT((analytic - FiniteDifferences(loss, distances)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(DiversityTerm, GradientMatchesFiniteDifferences) {
  const Eigen::MatrixXd shapelets = RandomMatrix(4, 8, 5);
  const auto loss = [](const Eigen::MatrixXd& s) { return DiversityTerm(s, 4.0).value; };
  EXPECT_LT((DiversityTerm(shapelets, 4.0).gradient - FiniteDifferences(loss, shapelets)).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(DiversityTerm, CountsEqualShapeletsAsOneEach) {
  const Eigen::MatrixXd shapelets = Eigen::MatrixXd::Ones(3, 5);
  EXPECT_NEAR(DiversityTerm(shapelets, 1.0).value, 9.0, 1e-12);
}

TEST(GaussianSimilarity, HasTheMedianSquaredDistanceAsItsVariance) {
  Eigen::MatrixXf series(3, 1);
  series << 0.0F, 1.0F, 3.0F;  // squared distances 1, 4, 9
  const Eigen::MatrixXd similarity = GaussianSimilarity(SquaredDistances(series));
  EXPECT_NEAR(similarity(0, 1), std::exp(-1.0 / 4.0), 1e-12);
  EXPECT_NEAR(similarity(1, 2), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(similarity(0, 0), 1.0, 1e-12);
}

TEST(ContrastiveWeights, SumToOneMinusTheRepulsion) {
  const Eigen::MatrixXd similarity = GaussianSimilarity(SquaredDistances(RandomMatrix(8, 5, 6).cast<float>()));
  EXPECT_NEAR(ContrastiveWeights(similarity, 3.0).sum(), 1.0 - 3.0, 1e-10);
  EXPECT_NEAR(ContrastiveWeights(similarity, 3.0).diagonal().cwiseAbs().sum(), 0.0, 1e-12);
}

TEST(PaperObjective, IsLeastIfAllMembershipsAreEqual) {
  const Eigen::MatrixXd weights =
      PaperWeights(GaussianSimilarity(SquaredDistances(RandomMatrix(6, 5, 7).cast<float>())));
  EXPECT_NEAR(SpectralTerm(Eigen::MatrixXd::Constant(6, 4, 0.25), weights).value, 0.0, 1e-12);
  EXPECT_GT(SpectralTerm(Membership(RandomMatrix(6, 4, 8)), weights).value, 0.0);
}

TEST(ShrinkToZero, ReachesExactZerosAndKeepsSigns) {
  Eigen::MatrixXd values(1, 4);
  values << 0.3, -0.3, 0.05, -0.05;
  ShrinkToZero(0.1, values);
  EXPECT_NEAR(values(0), 0.2, 1e-12);
  EXPECT_NEAR(values(1), -0.2, 1e-12);
  EXPECT_EQ(values(2), 0.0);
  EXPECT_EQ(values(3), 0.0);
}

}  // namespace
}  // namespace contact_shapelets::core
