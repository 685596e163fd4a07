// Equations 4 to 6 and their gradients, against values computed by NumPy.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "core/learning/bank_learner.h"
#include "core/learning/membership.h"
#include "core/learning/objective.h"
#include "golden/golden_values.h"

namespace contact_shapelets::core {
namespace {

/// A name of golden values, by the kind of weights.
std::string Name(Objective objective, const std::string& value) {
  return (objective == Objective::kPaper ? "objective.paper." : "objective.contrastive.") + value;
}

class GoldenObjective : public testing::TestWithParam<Objective> {
 protected:
  Eigen::MatrixXd Weights() const {
    const Eigen::MatrixXd similarity = test::Golden("objective.similarity");
    return GetParam() == Objective::kPaper ? PaperWeights(similarity)
                                           : ContrastiveWeights(similarity, test::GoldenNumber("objective.repulsion"));
  }
};

INSTANTIATE_TEST_SUITE_P(Weights, GoldenObjective, testing::Values(Objective::kPaper, Objective::kContrastive),
                         [](const auto& info) { return info.param == Objective::kPaper ? "Paper" : "Contrastive"; });

TEST_P(GoldenObjective, HasTheseWeights) {
  EXPECT_LT(test::LargestDifference(Weights(), test::Golden(Name(GetParam(), "weights"))), 1e-12);
}

TEST_P(GoldenObjective, HasThisSpectralTerm) {
  const Eigen::MatrixXd membership = Membership(test::Golden("objective.distances"));
  EXPECT_NEAR(SpectralTerm(membership, Weights()).value, test::GoldenNumber(Name(GetParam(), "spectral")), 1e-12);
}

TEST_P(GoldenObjective, HasThisGradientByTheDistances) {
  const Eigen::MatrixXd distances = test::Golden("objective.distances");
  const Eigen::MatrixXd membership = Membership(distances);
  const Eigen::MatrixXd gradient =
      DistanceGradient(distances, membership, SpectralTerm(membership, Weights()).gradient);
  EXPECT_LT(test::LargestDifference(gradient, test::Golden(Name(GetParam(), "spectral_gradient_by_distances"))), 1e-9);
}

TEST_P(GoldenObjective, HasThisValueAndGradientByTheShapelets) {
  const std::vector<Eigen::VectorXf> series = test::GoldenSeries("objective.series");
  const SeriesDistances distances(series, static_cast<int>(series.front().size()));
  LearnerOptions options;
  options.objective = GetParam();
  options.repulsion = test::GoldenNumber("objective.repulsion");
  options.diversity = test::GoldenNumber("objective.diversity_weight");
  options.flat_fraction = 0.0;
  BankLearner learner(series, distances, test::Golden("objective.shapelets").cast<float>(), options, 0, 1);
  std::vector<int> all(series.size());
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixXd gradient;
  // Matches are found in single precision.
  EXPECT_NEAR(learner.Evaluate(all, &gradient), test::GoldenNumber(Name(GetParam(), "value")), 1e-7);
  EXPECT_LT(test::LargestDifference(gradient, test::Golden(Name(GetParam(), "gradient"))), 1e-6);
}

TEST(GoldenSimilarity, IsThatOfTheSeries) {
  const Eigen::MatrixXd squared = SquaredDistances(test::Golden("objective.series").cast<float>());
  EXPECT_LT(test::LargestDifference(GaussianSimilarity(squared), test::Golden("objective.similarity")), 1e-9);
}

TEST(GoldenDiversity, IsTheSquaredNormOfH) {
  const Eigen::MatrixXd shapelets = test::Golden("objective.shapelets");
  EXPECT_NEAR(DiversityTerm(shapelets, 0.5 * static_cast<double>(shapelets.cols())).value,
              test::GoldenNumber("objective.diversity"), 1e-9);
}

}  // namespace
}  // namespace contact_shapelets::core
