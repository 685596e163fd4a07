#include "evaluation/protocol.h"

#include <gtest/gtest.h>

#include "core/numerics/random.h"
#include "core/planted_series.h"
#include "evaluation/feature_clusterer.h"
#include "evaluation/methods.h"

namespace contact_shapelets::evaluation {
namespace {

const core::TrainerOptions& Defaults() {
  static const core::TrainerOptions options;
  return options;
}

/// A method with perfect features: the class, which it reads from the first value of a series.
class PerfectClusterer : public FeatureClusterer {
 public:
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override {
    Eigen::MatrixXf features(series.size(), 1);
    for (std::size_t index = 0; index < series.size(); ++index) {
      Eigen::Index highest = 0;
      series[index].maxCoeff(&highest);
      features(static_cast<Eigen::Index>(index), 0) = static_cast<float>(highest);
    }
    return features;
  }

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& /*train*/, int /*clusters*/, std::uint64_t /*seed*/) override {}
};

/// Returns `count` series of 4 samples. The class is the place of the only peak.
LabelledSeries Peaks(int count, int classes) {
  LabelledSeries peaks;
  peaks.classes.resize(count);
  for (int index = 0; index < count; ++index) {
    peaks.classes[index] = index % classes;
    Eigen::VectorXf series = Eigen::VectorXf::Zero(4);
    series[index % classes] = 1.0F + static_cast<float>(index);
    peaks.series.push_back(series);
  }
  return peaks;
}

DataSet Peaks() {
  DataSet data_set;
  data_set.name = "peaks";
  data_set.train = Peaks(12, 3);
  data_set.test = Peaks(9, 3);
  data_set.class_count = 3;
  return data_set;
}

DataSet Planted(int spread) {
  DataSet data_set;
  data_set.name = "planted";
  data_set.class_count = 3;
  std::uint64_t seed = 21;
  for (LabelledSeries* split : {&data_set.train, &data_set.test}) {
    const std::vector<core::Episode> episodes = core::PlantedEpisodes(10, spread, seed++);
    split->classes.resize(static_cast<Eigen::Index>(episodes.size()));
    for (std::size_t index = 0; index < episodes.size(); ++index) {
      split->series.push_back(episodes[index].force);
      split->classes[static_cast<Eigen::Index>(index)] = episodes[index].outcome.back() - '0';
    }
  }
  return data_set;
}

core::TrainerOptions QuickOptions() {
  core::TrainerOptions options;
  options.learner.scales = {0.1, 0.25, 0.4};
  options.learner.steps = 10;
  return options;
}

TEST(Evaluate, GivesPerfectFeaturesARandIndexOfOneInAllThreeScores) {
  PerfectClusterer clusterer;
  const EvaluationResult result = Evaluate(Peaks(), "perfect", 4, &clusterer);
  for (const PartitionScores& scores : {result.train, result.test, result.test_anew}) {
    EXPECT_EQ(scores.rand_index, 1.0);
    EXPECT_EQ(scores.adjusted_rand_index, 1.0);
    EXPECT_EQ(scores.accuracy, 1.0);
  }
  EXPECT_EQ(result.data_set, "peaks");
  EXPECT_EQ(result.method, "perfect");
  EXPECT_EQ(result.seed, 4U);
}

TEST(Evaluate, ZNormalisesSeries) {
  // Peaks of any height have one shape after z-normalisation.
  const std::unique_ptr<Clusterer> kmeans = MakeClusterer("kmeans", Defaults());
  EXPECT_EQ(Evaluate(Peaks(), "kmeans", 0, kmeans.get()).test.rand_index, 1.0);
}

TEST(Evaluate, DoesNotLetTheClassesReachTheMethod) {
  DataSet data_set = Planted(0);
  const std::unique_ptr<Clusterer> first = MakeClusterer("nn_stne", QuickOptions());
  const double truth = Evaluate(data_set, "nn_stne", 1, first.get()).train.rand_index;
  data_set.train.classes.setZero();
  const std::unique_ptr<Clusterer> second = MakeClusterer("nn_stne", QuickOptions());
  Evaluate(data_set, "nn_stne", 1, second.get());
  const Eigen::MatrixXf once = first->Transform(data_set.test.series);
  EXPECT_EQ(once, second->Transform(data_set.test.series));
  EXPECT_EQ(first->Assign(once), second->Assign(once));
  EXPECT_GT(truth, 0.9);
}

/// The methods of a default evaluation.
class EveryMethod : public testing::TestWithParam<std::string> {};

TEST_P(EveryMethod, GivesEqualScoresForEqualSeedsAndNoClusterOutsideTheRange) {
  const DataSet data_set = Planted(0);
  const std::unique_ptr<Clusterer> once = MakeClusterer(GetParam(), QuickOptions());
  const std::unique_ptr<Clusterer> again = MakeClusterer(GetParam(), QuickOptions());
  const EvaluationResult first = Evaluate(data_set, GetParam(), 2, once.get());
  const EvaluationResult second = Evaluate(data_set, GetParam(), 2, again.get());
  EXPECT_EQ(first.train.rand_index, second.train.rand_index);
  EXPECT_EQ(first.test.rand_index, second.test.rand_index);
  EXPECT_EQ(first.test_anew.rand_index, second.test_anew.rand_index);
  const Eigen::VectorXi labels = once->Assign(once->Transform(data_set.test.series));
  EXPECT_EQ(labels.size(), 30);
  EXPECT_GE(labels.minCoeff(), 0);
  EXPECT_LT(labels.maxCoeff(), 3);
}

TEST_P(EveryMethod, AcceptsSeriesOfDifferentLengths) {
  const std::unique_ptr<Clusterer> clusterer = MakeClusterer(GetParam(), QuickOptions());
  const EvaluationResult result = Evaluate(Planted(30), GetParam(), 0, clusterer.get());
  EXPECT_GT(result.test.rand_index, 0.0);
  EXPECT_LE(result.test.rand_index, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(ClustererNames()),
                         [](const auto& info) { return info.param; });

TEST(MakeClusterer, RefusesAnUnknownMethodAndNamesTheKnownOnes) {
  for (const std::string name : {"magic", "udfs_k", "udfs_k0", "udfs_k1234", "udfs_kx", "udfs_k-1"}) {
    try {
      MakeClusterer(name, Defaults());
      FAIL() << "accepted " << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("nn_stne_paper"), std::string::npos);
    }
  }
  EXPECT_NE(MakeClusterer("udfs_k12", Defaults()), nullptr);
}

TEST(SplitByClass, HalvesEveryClassAndKeepsEverySeries) {
  const LabelledSeries all = Peaks(30, 3);
  const DataSet data_set = SplitByClass("half", all, 3, 0.5, 0);
  EXPECT_EQ(data_set.train.series.size() + data_set.test.series.size(), 30U);
  for (int one = 0; one < 3; ++one) {
    EXPECT_EQ((data_set.train.classes.array() == one).count(), 5);
    EXPECT_EQ((data_set.test.classes.array() == one).count(), 5);
  }
}

TEST(SplitByClass, DependsOnTheSeedAlone) {
  const LabelledSeries all = Peaks(30, 3);
  const auto train = [&all](std::uint64_t seed) { return SplitByClass("", all, 3, 0.5, seed).train.series; };
  EXPECT_EQ(train(5), train(5));
  EXPECT_NE(train(5), train(6));
}

TEST(SplitByClass, HasAMemberOfAPairInEachPart) {
  const DataSet data_set = SplitByClass("pairs", Peaks(6, 3), 3, 0.9, 1);
  EXPECT_EQ(data_set.train.series.size(), 3U);
  EXPECT_EQ(data_set.test.series.size(), 3U);
}

}  // namespace
}  // namespace contact_shapelets::evaluation
