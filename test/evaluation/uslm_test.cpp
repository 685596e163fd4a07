#include "evaluation/uslm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics/random.h"
#include "core/planted_series.h"
#include "evaluation/data_set.h"

namespace contact_shapelets::evaluation {
namespace {

Eigen::MatrixXd PlantedRows(int per_pattern, std::uint64_t seed) {
  std::vector<Eigen::VectorXf> series;
  for (const core::Episode& episode : core::PlantedEpisodes(per_pattern, 0, seed)) series.push_back(episode.force);
  return EqualLengthRows(series, 120).cast<double>();
}

TEST(SoftMinimumDistances, MatchesACaseDoneByHand) {
  // The windows (0, 1) and (1, 3) have mean squared differences of 0.5 and 2 from (1, 1).
  Eigen::MatrixXd series(1, 3);
  series << 0.0, 1.0, 3.0;
  Eigen::MatrixXd shapelet(1, 2);
  shapelet << 1.0, 1.0;
  const double far = 4.0 / 2.0;
  const double near = 1.0 / 2.0;
  const double expected = (near * std::exp(-near) + far * std::exp(-far)) / (std::exp(-near) + std::exp(-far));
  EXPECT_NEAR(SoftMinimumDistances(series, shapelet, -1.0)(0, 0), expected, 1e-12);
}

TEST(SoftMinimumDistances, TendsToTheLeastDistance) {
  const Eigen::MatrixXd series = PlantedRows(1, 1);
  const Eigen::MatrixXd shapelet = series.row(0).segment(17, 20);
  EXPECT_NEAR(SoftMinimumDistances(series, shapelet, -1e4)(0, 0), 0.0, 1e-9);
}

TEST(SoftMinimumDistances, StaysFiniteForDistancesOfAnySize) {
  const Eigen::MatrixXd series = 1e3 * PlantedRows(1, 1);
  EXPECT_TRUE(SoftMinimumDistances(series, Eigen::MatrixXd::Ones(2, 20), -100.0).allFinite());
}

class Uslm : public testing::Test {
 protected:
  Uslm() : learner_(PlantedRows(6, 2), 3, UslmOptions{}, 3) {}

  UslmLearner learner_;
};

TEST_F(Uslm, StartsWithOrthonormalPseudoLabels) {
  const Eigen::MatrixXd& labels = learner_.pseudo_labels();
  EXPECT_TRUE((labels * labels.transpose()).isIdentity(1e-9));
}

TEST_F(Uslm, LowersItsObjectiveByTheUpdateOfShapelets) {
  for (int round = 0; round < 5; ++round) {
    const double before = learner_.Objective();
    ASSERT_TRUE(learner_.UpdateShapelets());
    EXPECT_LT(learner_.Objective(), before);
  }
}

TEST_F(Uslm, LowersItsObjectiveByTheUpdateOfPseudoLabels) {
  // Pseudo-labels are best if the classifier follows them, so both sides have the best classifier.
  for (int round = 0; round < 3; ++round) ASSERT_TRUE(learner_.UpdateShapelets());
  learner_.UpdateClassifier();
  const double before = learner_.Objective();
  learner_.UpdatePseudoLabels();
  learner_.UpdateClassifier();
  EXPECT_LT(learner_.Objective(), before);
}

TEST_F(Uslm, LowersItsObjectiveByTheUpdateOfTheClassifier) {
  ASSERT_TRUE(learner_.UpdateShapelets());
  const double before = learner_.Objective();
  learner_.UpdateClassifier();
  EXPECT_LT(learner_.Objective(), before);
}

TEST_F(Uslm, FindsAClassifierThatNoSmallChangeImproves) {
  learner_.UpdateClassifier();
  const double best = learner_.Objective();
  const Eigen::MatrixXd classifier = learner_.classifier();
  core::Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::MatrixXd changed = classifier;
    for (Eigen::Index index = 0; index < changed.size(); ++index) changed.data()[index] += 1e-3 * random.Normal();
    learner_.set_classifier(changed);
    EXPECT_GT(learner_.Objective(), best);
  }
}

TEST_F(Uslm, HasAGradientThatMatchesFiniteDifferences) {
  UslmOptions options;
  options.softness = -5.0;
  UslmLearner learner(PlantedRows(4, 7), 3, options, 8);
  learner.UpdateShapelets();
  const Eigen::MatrixXd shapelets = learner.shapelets();
  const Eigen::MatrixXd gradient = learner.ShapeletGradient();
  const double step = 1e-5;
  for (const auto& [row, column] : {std::pair{0, 0}, {1, 7}, {2, 13}, {3, 23}}) {
    Eigen::MatrixXd changed = shapelets;
    changed(row, column) += step;
    learner.set_shapelets(changed);
    const double above = learner.Objective();
    changed(row, column) -= 2.0 * step;
    learner.set_shapelets(changed);
    const double below = learner.Objective();
    EXPECT_NEAR(gradient(row, column), (above - below) / (2.0 * step), 1e-5 * gradient.cwiseAbs().maxCoeff());
  }
}

TEST_F(Uslm, LowersItsObjectiveByLearning) {
  const double before = learner_.Objective();
  learner_.Learn();
  EXPECT_LT(learner_.Objective(), before);
}

TEST(UslmLearner, RefusesInvalidInput) {
  const Eigen::MatrixXd series = PlantedRows(1, 1);
  EXPECT_THROW(UslmLearner(series, 3, UslmOptions{}, 0), std::invalid_argument);
  EXPECT_THROW(UslmLearner(series.leftCols(1), 2, UslmOptions{}, 0), std::invalid_argument);
  UslmOptions options;
  options.softness = 1.0;
  EXPECT_THROW(UslmLearner(series, 2, options, 0), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
