#include "core/learning/learner.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/learning/bank_learner.h"
#include "core/numerics/series.h"
#include "core/planted_series.h"

namespace contact_shapelets::core {
namespace {

std::vector<Eigen::VectorXf> PlantedSeriesList(int per_pattern, std::uint64_t seed) {
  std::vector<Eigen::VectorXf> series;
  for (const Episode& episode : PlantedEpisodes(per_pattern, 0, seed)) series.push_back(ZNormalised(episode.force));
  return series;
}

Eigen::MatrixXf SmoothShapelets(int count, int length, std::uint64_t seed) {
  Random random(seed);
  Eigen::MatrixXf shapelets(count, length);
  for (int k = 0; k < count; ++k) {
    float value = 0.0F;
    for (int m = 0; m < length; ++m) shapelets(k, m) = value += static_cast<float>(random.Normal());
    shapelets.row(k) = ZNormalised(shapelets.row(k).transpose()).transpose();
  }
  return shapelets;
}

TEST(ShapeletCount, FollowsEquationOne) {
  EXPECT_EQ(ShapeletCount(489, 433, 64, 3), 19);  // log2(489 * 369 * 3) = 19.05
  EXPECT_EQ(ShapeletCount(1, 3, 2, 2), 2);
}

TEST(BankLearner, GradientOfTheWholeObjectiveMatchesFiniteDifferences) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(4, 11);
  const Eigen::MatrixXf start = SmoothShapelets(3, 16, 12);
  LearnerOptions options;
  options.diversity = 1.0;
  const SeriesDistances distances(series, 120);
  BankLearner learner(series, distances, start, options, 13, 1);
  std::vector<int> all(series.size());
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixXd analytic;
  learner.Evaluate(all, &analytic);

  // Similarities are in single precision, so the step is wide, and the tolerance is relative to the largest entry.
  constexpr double kStep = 2e-3;
  Eigen::MatrixXd point = start.cast<double>();
  Eigen::MatrixXd ignored;
  double largest_error = 0.0;
  for (Eigen::Index index = 0; index < point.size(); ++index) {
    const double value = point(index);
    point(index) = value + kStep;
    learner.set_shapelets(point);
    const double above = learner.Evaluate(all, &ignored);
    point(index) = value - kStep;
    learner.set_shapelets(point);
    const double below = learner.Evaluate(all, &ignored);
    point(index) = value;
    largest_error = std::max(largest_error, std::abs((above - below) / (2.0 * kStep) - analytic(index)));
  }
  EXPECT_LT(largest_error, 0.02 * analytic.cwiseAbs().maxCoeff());
}

TEST(BankLearner, StepsLowerTheObjective) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(10, 21);
  LearnerOptions options;
  options.batch = 1000;
  const SeriesDistances distances(series, 120);
  BankLearner learner(series, distances, SmoothShapelets(6, 24, 22), options, 23, 1);
  const double first = learner.Step();
  double last = first;
  for (int step = 0; step < 40; ++step) last = learner.Step();
  EXPECT_LT(last, first);
}

TEST(LearnBanks, GivesTheSameShapeletsForAnyNumberOfThreads) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(8, 31);
  LearnerOptions options;
  options.scales = {0.1, 0.3};
  options.steps = 10;
  const std::vector<ShapeletBank> one = LearnBanks(series, 3, options, 5, 1);
  const std::vector<ShapeletBank> four = LearnBanks(series, 3, options, 5, 4);
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(four.size(), 2U);
  for (std::size_t bank = 0; bank < one.size(); ++bank) {
    EXPECT_TRUE((one[bank].shapelets.array() == four[bank].shapelets.array()).all());
  }
}

TEST(LearnBanks, OtherSeedsGiveOtherShapelets) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(8, 31);
  LearnerOptions options;
  options.scales = {0.2};
  options.steps = 2;
  EXPECT_FALSE(
      LearnBanks(series, 3, options, 5, 1)[0].shapelets.isApprox(LearnBanks(series, 3, options, 6, 1)[0].shapelets));
}

TEST(LearnBanks, SparsityShortensShapelets) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(10, 41);
  LearnerOptions options;
  options.scales = {0.4};
  options.steps = 40;
  const std::vector<Shapelet> whole = CutShapelets(LearnBanks(series, 3, options, 7, 1), options.shortest);
  options.sparsity = 1.0;
  const std::vector<Shapelet> cut = CutShapelets(LearnBanks(series, 3, options, 7, 1), options.shortest);
  const auto samples = [](const std::vector<Shapelet>& shapelets) {
    Eigen::Index sum = 0;
    for (const Shapelet& shapelet : shapelets) sum += shapelet.values.size();
    return sum;
  };
  EXPECT_LT(samples(cut), samples(whole));
  for (const Shapelet& shapelet : cut) EXPECT_GE(shapelet.values.size(), options.shortest);
}

TEST(LearnBanks, StopsIfTheCallbackReturnsFalse) {
  const std::vector<Eigen::VectorXf> series = PlantedSeriesList(6, 51);
  LearnerOptions options;
  options.scales = {0.2, 0.3};
  int calls = 0;
  EXPECT_TRUE(LearnBanks(series, 3, options, 7, 1, [&calls](int, int, double) { return ++calls < 3; }).empty());
  EXPECT_EQ(calls, 3);
}

TEST(LearnBanks, LearnsFromSeriesOfDifferentLengths) {
  std::vector<Eigen::VectorXf> series;
  for (const Episode& episode : PlantedEpisodes(6, 60, 61)) series.push_back(episode.force);
  LearnerOptions options;
  options.scales = {0.1, 0.9};
  options.steps = 3;
  for (const ShapeletBank& bank : LearnBanks(series, 3, options, 1, 1)) EXPECT_TRUE(bank.shapelets.allFinite());
}

TEST(LearnerOptions, NamesEveryFaultAtOnce) {
  LearnerOptions options;
  options.scales = {1.5};
  options.steps = -1;
  options.flat_fraction = 1.0;
  const std::string faults = options.Faults();
  for (const char* name : {"scales", "steps", "flat_fraction"}) EXPECT_NE(faults.find(name), std::string::npos) << name;
}

TEST(CutShapelets, CutsZerosAtTheEndsButNotWithin) {
  ShapeletBank bank;
  bank.shapelets.resize(1, 10);
  bank.shapelets << 0, 0, 1, 2, 0, 3, 4, 0, 0, 0;
  const std::vector<Shapelet> cut = CutShapelets({bank}, 3);
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0].values.size(), 5);
  EXPECT_NEAR(cut[0].values.sum(), 0.0F, 1e-5F);
}

}  // namespace
}  // namespace contact_shapelets::core
