#include "contact_shapelets/core/classifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

constexpr int kLength = 20;

/// Returns a pattern. Patterns differ in shape alone: a bump, a step, three waves.
double Shape(int pattern, double phase) {
  switch (pattern) {
    case 0:
      return std::sin(M_PI * phase);
    case 1:
      return phase < 0.5 ? 1.0 : -1.0;
    default:
      return std::sin(6.0 * M_PI * phase);
  }
}

/// Returns a smooth approach with one pattern of 0.2 s at 0.5 s, at least 0, sampled every `period` [s].
Episode EpisodeWith(int pattern, std::uint64_t seed, double period = 0.01) {
  Random random(seed);
  Episode episode;
  episode.sample_period = period;
  episode.force.resize(static_cast<Eigen::Index>(std::lround(1.2 / period)));
  for (Eigen::Index index = 0; index < episode.force.size(); ++index) {
    const double time = (static_cast<double>(index) + 0.5) * period;
    const double phase = (time - 0.5) / 0.2;
    const double value = phase >= 0.0 && phase < 1.0 ? 5.0 * Shape(pattern, phase) : 0.0;
    episode.force[index] = static_cast<float>(10.0 + value + 0.02 * random.Normal());
  }
  return episode;
}

/// Returns a model with a shapelet and a cluster for each pattern. Each centroid is the features of one episode.
Model ThreePatterns() {
  Model model;
  model.id = "test";
  model.sample_period = 0.01;
  for (int pattern = 0; pattern < 3; ++pattern) {
    Eigen::VectorXf values(kLength);
    for (int m = 0; m < kLength; ++m) values[m] = static_cast<float>(Shape(pattern, (m + 0.5) / kLength));
    model.shapelets.push_back({0, 1, ZNormalised(values)});
  }
  const FeatureExtractor extractor(model.shapelets, model.flat_fraction);
  for (int pattern = 0; pattern < 3; ++pattern) {
    const ShapeletDistances distances = extractor.Compute(EpisodeWith(pattern, 100).force);
    Cluster cluster;
    cluster.centroid = model.Features(distances.distances.transpose()).transpose();
    cluster.novelty_limit = 1.0F;
    model.clusters.push_back(cluster);
  }
  return model;
}

TEST(Classifier, TakesTheNearestCentroid) {
  const Classifier classifier(ThreePatterns());
  for (int pattern = 0; pattern < 3; ++pattern) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Diagnosis diagnosis = classifier.Classify(EpisodeWith(pattern, seed)).diagnosis;
      EXPECT_EQ(diagnosis.cluster, pattern);
      EXPECT_EQ(diagnosis.nearest_cluster, pattern);
      EXPECT_EQ(diagnosis.event, "cluster_" + std::to_string(pattern));
      EXPECT_LT(diagnosis.novelty, 1.0F);
    }
  }
}

TEST(Classifier, ConfidenceIsTheNearestClustersShare) {
  const Model model = ThreePatterns();
  const Classifier classifier(model);
  const Classification result = classifier.Classify(EpisodeWith(1, 3));
  const Eigen::VectorXf features = model.Features(result.features.distances.transpose()).transpose();
  double sum = 0.0;
  for (const Cluster& cluster : model.clusters) sum += 1.0 / (cluster.centroid - features).squaredNorm();
  EXPECT_NEAR(result.diagnosis.confidence, 1.0 / (model.clusters[1].centroid - features).squaredNorm() / sum, 1e-4);
}

TEST(Classifier, ConfidenceStaysInItsRange) {
  Random random(1);
  const Classifier classifier(ThreePatterns());
  for (int round = 0; round < 30; ++round) {
    Episode episode = EpisodeWith(0, 1);
    for (Eigen::Index index = 0; index < episode.force.size(); ++index) {
      episode.force[index] = static_cast<float>(std::abs(random.Normal()));
    }
    const float confidence = classifier.Classify(episode).diagnosis.confidence;
    EXPECT_GE(confidence, 1.0F / 3.0F - 1e-5F);
    EXPECT_LE(confidence, 1.0F);
  }
}

TEST(Classifier, IsSureOfAnEpisodeOnACentroidAndOfTheOnlyCluster) {
  const Classifier classifier(ThreePatterns());
  EXPECT_NEAR(classifier.Classify(EpisodeWith(2, 100)).diagnosis.confidence, 1.0F, 1e-4F);
  EXPECT_EQ(classifier.Classify(EpisodeWith(2, 100)).diagnosis.novelty, 0.0F);
  Model one = ThreePatterns();
  one.clusters.resize(1);
  EXPECT_EQ(Classifier(one).Classify(EpisodeWith(0, 1)).diagnosis.confidence, 1.0F);
}

TEST(Classifier, CallsAnEpisodeBeyondTheNoveltyLimitUnknown) {
  Model model = ThreePatterns();
  const Episode episode = EpisodeWith(1, 5);
  const float novelty = Classifier(model).Classify(episode).diagnosis.novelty;
  ASSERT_GT(novelty, 0.0F);
  for (Cluster& cluster : model.clusters) cluster.novelty_limit = 0.5F * novelty;
  const Diagnosis diagnosis = Classifier(model).Classify(episode).diagnosis;
  EXPECT_EQ(diagnosis.cluster, -1);
  EXPECT_EQ(diagnosis.nearest_cluster, 1);
  EXPECT_EQ(diagnosis.event, "unknown");
  EXPECT_NEAR(diagnosis.novelty, 2.0F, 1e-4F);
}

TEST(Classifier, GivesAFlatEpisodeADiagnosisWithoutNan) {
  Episode flat = EpisodeWith(0, 1);
  flat.force.setConstant(2.0F);
  const Classification result = Classifier(ThreePatterns()).Classify(flat);
  EXPECT_TRUE(std::isfinite(result.diagnosis.confidence));
  EXPECT_TRUE(std::isfinite(result.diagnosis.novelty));
  EXPECT_EQ(result.features.distances, Eigen::VectorXf::Ones(3));
}

class PeriodTest : public testing::TestWithParam<double> {};

TEST_P(PeriodTest, AnEpisodeOfAnotherPeriodHasTheSameFeatures) {
  const Classifier classifier(ThreePatterns());
  for (int pattern = 0; pattern < 3; ++pattern) {
    const Classification same = classifier.Classify(EpisodeWith(pattern, 1));
    const Classification other = classifier.Classify(EpisodeWith(pattern, 1, GetParam()));
    EXPECT_EQ(other.diagnosis.nearest_cluster, pattern);
    EXPECT_LT((same.features.distances - other.features.distances).cwiseAbs().maxCoeff(), 0.05F);
    EXPECT_NEAR(other.features.match_start[pattern], 50, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, PeriodTest, testing::Values(0.001, 0.002, 0.005, 0.0125, 0.015));

TEST(Classifier, AveragesTheNoiseOfAFasterEpisode) {
  // 1 N of noise at 10 kHz is 0.1 N at 100 Hz. Taking every hundredth sample would keep 1 N.
  Random random(2);
  Episode fast = EpisodeWith(0, 1, 0.0001);
  for (Eigen::Index index = 0; index < fast.force.size(); ++index) {
    fast.force[index] += static_cast<float>(random.Normal());
  }
  const Classifier classifier(ThreePatterns());
  const float clean = classifier.Classify(EpisodeWith(0, 1)).features.distances[0];
  EXPECT_NEAR(classifier.Classify(fast).features.distances[0], clean, 0.01F);
}

TEST(Classifier, NamesClusters) {
  Classifier classifier(ThreePatterns());
  classifier.NameCluster(1, "switched");
  EXPECT_EQ(classifier.Classify(EpisodeWith(1, 1)).diagnosis.event, "switched");
  EXPECT_EQ(classifier.Classify(EpisodeWith(2, 1)).diagnosis.event, "cluster_2");
  EXPECT_EQ(classifier.model().clusters[1].label, "switched");
  EXPECT_THROW(classifier.NameCluster(3, "other"), std::invalid_argument);
  EXPECT_THROW(classifier.NameCluster(-1, "other"), std::invalid_argument);
  EXPECT_THROW(classifier.NameCluster(0, ""), std::invalid_argument);
}

TEST(Classifier, RefusesAnEpisodeThatItCannotJudge) {
  const Classifier classifier(ThreePatterns());
  Episode episode = EpisodeWith(0, 1);
  episode.force[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(classifier.Classify(episode), std::invalid_argument);
  episode.sample_period = 0.005;
  EXPECT_THROW(classifier.Classify(episode), std::invalid_argument);
  for (const double period : {0.01, 0.02}) {
    Episode one = EpisodeWith(0, 1);
    one.force = Eigen::VectorXf::Ones(1);
    one.sample_period = period;
    EXPECT_THROW(classifier.Classify(one), std::invalid_argument);
    one.force.resize(0);
    EXPECT_THROW(classifier.Classify(one), std::invalid_argument);
  }
  for (const double period : {0.0, -0.01, 1e-9, 1e6, std::nan("")}) {
    Episode wrong = EpisodeWith(0, 1);
    wrong.sample_period = period;
    EXPECT_THROW(classifier.Classify(wrong), std::invalid_argument);
  }
}

TEST(Classifier, RefusesAFaultyModel) {
  EXPECT_THROW(Classifier{Model()}, std::invalid_argument);
  Model model = ThreePatterns();
  model.clusters[0].centroid.resize(2);
  EXPECT_THROW(Classifier{model}, std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
