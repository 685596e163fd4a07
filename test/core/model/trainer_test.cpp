#include "contact_shapelets/core/trainer.h"

#include <gtest/gtest.h>

#include <limits>

#include "contact_shapelets/core/classifier.h"
#include "core/numerics/random.h"
#include "core/planted_series.h"

namespace contact_shapelets::core {
namespace {

TrainerOptions QuickOptions() {
  TrainerOptions options;
  options.learner.scales = {0.1, 0.25, 0.4};
  options.learner.steps = 10;
  options.threads = 2;
  options.seed = 3;
  return options;
}

TEST(TrainModel, FindsPlantedPatternsAndNamesThemByOutcomes) {
  const TrainingResult result = TrainModel(PlantedEpisodes(20, 20, 1), QuickOptions());
  const Classifier classifier(result.model);
  for (const Episode& episode : PlantedEpisodes(10, 20, 2)) {
    const Diagnosis diagnosis = classifier.Classify(episode).diagnosis;
    EXPECT_EQ(result.model.EventOf(diagnosis.nearest_cluster), episode.outcome);
    EXPECT_GT(diagnosis.confidence, 1.0F / 3.0F);
    EXPECT_LE(diagnosis.confidence, 1.0F);
  }
}

TEST(TrainModel, LabelsEpisodesThatWereNotDrawnToVoteLikeThoseThatWere) {
  TrainerOptions options = QuickOptions();
  options.voting_episodes = 12;
  const std::vector<Episode> episodes = PlantedEpisodes(20, 0, 7);
  const TrainingResult result = TrainModel(episodes, options);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    EXPECT_EQ(result.model.EventOf(result.labels[static_cast<Eigen::Index>(index)]), episodes[index].outcome);
  }
}

TEST(TrainModel, LetsNoMoreEpisodesVoteThanAsked) {
  // Walks have no groups, so another set of voting episodes splits them in another way.
  Random random(9);
  std::vector<Episode> episodes(40);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    episodes[index].id = std::to_string(index);
    episodes[index].sample_period = 0.01;
    episodes[index].force = Eigen::VectorXf(120);
    float value = 0.0F;
    for (Eigen::Index sample = 0; sample < 120; ++sample) {
      episodes[index].force[sample] = value += static_cast<float>(random.Normal());
    }
  }
  TrainerOptions options = QuickOptions();
  const Eigen::VectorXi all = TrainModel(episodes, options).labels;
  options.voting_episodes = 12;
  EXPECT_NE(TrainModel(episodes, options).labels, all);
}

TEST(TrainModel, ClustersWithoutVotersByTheLearnedShapeletsAlone) {
  TrainerOptions options = QuickOptions();
  options.voters = 0;
  const std::vector<Episode> episodes = PlantedEpisodes(20, 0, 8);
  const TrainingResult result = TrainModel(episodes, options);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    EXPECT_EQ(result.model.EventOf(result.labels[static_cast<Eigen::Index>(index)]), episodes[index].outcome);
  }
}

TEST(TrainModel, LearnsWithoutTheOutcomes) {
  std::vector<Episode> episodes = PlantedEpisodes(12, 0, 4);
  const Model named = TrainModel(episodes, QuickOptions()).model;
  for (Episode& episode : episodes) episode.outcome.clear();
  const Model unnamed = TrainModel(episodes, QuickOptions()).model;
  EXPECT_EQ(named.id, unnamed.id);
  EXPECT_EQ(unnamed.EventOf(2), "cluster_2");
}

TEST(TrainModel, GivesTheSameModelAndLabelsForAnyNumberOfThreads) {
  TrainerOptions options = QuickOptions();
  options.threads = 1;
  const TrainingResult one = TrainModel(PlantedEpisodes(10, 10, 5), options);
  options.threads = 3;
  const TrainingResult three = TrainModel(PlantedEpisodes(10, 10, 5), options);
  EXPECT_EQ(one.model.id, three.model.id);
  EXPECT_EQ(one.labels, three.labels);
}

TEST(TrainModel, CallsAnEpisodeUnlikeAnyTrainingEpisodeUnknown) {
  const Classifier classifier(TrainModel(PlantedEpisodes(20, 0, 6), QuickOptions()).model);
  Episode strange;
  strange.sample_period = 0.01;
  strange.force = Eigen::VectorXf::LinSpaced(120, 0.0F, 1.0F);
  const Diagnosis diagnosis = classifier.Classify(strange).diagnosis;
  EXPECT_GT(diagnosis.novelty, 1.0F);
  EXPECT_EQ(diagnosis.cluster, -1);
  EXPECT_EQ(diagnosis.event, "unknown");
}

TEST(TrainModel, GivesAClusterOfEqualEpisodesTheLimitOfOthers) {
  std::vector<Episode> episodes = PlantedEpisodes(20, 0, 10);
  const Episode first = episodes.front();
  for (Episode& episode : episodes) {
    if (episode.outcome == first.outcome) episode.force = first.force;
  }
  const TrainingResult result = TrainModel(episodes, QuickOptions());
  const std::vector<Cluster>& clusters = result.model.clusters;
  const int equal = result.labels[0];
  ASSERT_EQ(result.model.EventOf(equal), first.outcome);
  EXPECT_TRUE(clusters[equal].novelty_limit == clusters[(equal + 1) % 3].novelty_limit ||
              clusters[equal].novelty_limit == clusters[(equal + 2) % 3].novelty_limit);
}

TEST(TrainModel, HasAnIdThatIsOfItsInputAlone) {
  std::vector<Episode> episodes = PlantedEpisodes(6, 0, 4);
  const Model model = TrainModel(episodes, QuickOptions()).model;
  // What other compilers and processors make of one recording.
  for (Episode& episode : episodes) {
    episode.force = (1000.0F * episode.force).array().round().matrix() / 1000.0F;
  }
  const Model rounded = TrainModel(episodes, QuickOptions()).model;
  EXPECT_NE(rounded.shapelets[0].values, model.shapelets[0].values);
  EXPECT_EQ(rounded.id, model.id);
}

TEST(TrainModel, RefusesEpisodesOfWhichTheModelWouldBeTooLarge) {
  std::vector<Episode> episodes = PlantedEpisodes(2, 0, 4);
  for (Episode& episode : episodes) episode.force = Eigen::VectorXf::LinSpaced(600'000, 0.0F, 9.0F);
  TrainerOptions options = QuickOptions();
  options.learner.scales = {0.9};
  try {
    TrainModel(episodes, options);
    FAIL() << "it trained";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("raise sample_period"), std::string::npos) << error.what();
  }
}

TEST(TakeIncomplete, TakesThoseThatLackSamplesUnlessTheyAreAskedFor) {
  std::vector<Episode> episodes = PlantedEpisodes(2, 0, 1);
  episodes[1].complete = false;
  episodes[4].complete = false;
  TrainerOptions options;
  options.incomplete = true;
  EXPECT_EQ(TakeIncomplete(options, &episodes), 0);
  EXPECT_EQ(episodes.size(), 6U);
  options.incomplete = false;
  EXPECT_EQ(TakeIncomplete(options, &episodes), 2);
  std::vector<std::string> left;
  for (const Episode& episode : episodes) left.push_back(episode.id);
  EXPECT_EQ(left, (std::vector<std::string>{"0", "2", "3", "5"}));
}

TEST(TrainModel, RefusesFewerEpisodesThanClusters) {
  EXPECT_THROW(TrainModel({PlantedEpisodes(1, 0, 1).front()}, QuickOptions()), std::invalid_argument);
}

TEST(TrainModel, RefusesEpisodesThatAreAllFlat) {
  std::vector<Episode> episodes = PlantedEpisodes(4, 0, 1);
  for (Episode& episode : episodes) episode.force.setConstant(2.5F);
  EXPECT_THROW(TrainModel(episodes, QuickOptions()), std::invalid_argument);
}

TEST(TrainModel, RefusesAValueThatIsNotFinite) {
  std::vector<Episode> episodes = PlantedEpisodes(4, 0, 1);
  episodes[2].force[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(TrainModel(episodes, QuickOptions()), std::invalid_argument);
}

TEST(TrainModel, StopsWhenItIsCancelled) {
  EXPECT_THROW(TrainModel(PlantedEpisodes(4, 0, 1), QuickOptions(), [](const TrainingProgress&) { return false; }),
               Cancelled);
}

TEST(TrainModel, StopsWhenItIsCancelledDuringTheVote) {
  bool learned = false;
  EXPECT_THROW(TrainModel(PlantedEpisodes(4, 0, 1), QuickOptions(),
                          [&learned](const TrainingProgress& progress) {
                            learned = learned || progress.fraction_done > 0.96;
                            return !learned;
                          }),
               Cancelled);
  EXPECT_TRUE(learned);
}

TEST(TrainModel, ReportsProgressThatEndsAtOne) {
  double last = 0.0;
  TrainModel(PlantedEpisodes(6, 0, 1), QuickOptions(), [&last](const TrainingProgress& progress) {
    EXPECT_GE(progress.fraction_done, last);
    last = progress.fraction_done;
    return true;
  });
  EXPECT_EQ(last, 1.0);
}

TEST(Classifier, ResamplesAnEpisodeOfAnotherSamplePeriod) {
  const Classifier classifier(TrainModel(PlantedEpisodes(20, 0, 8), QuickOptions()).model);
  const Episode episode = PlantedEpisodes(1, 0, 9)[1];
  Episode doubled = episode;
  doubled.sample_period = 0.005;
  doubled.force.resize(2 * episode.force.size());
  for (Eigen::Index q = 0; q < doubled.force.size(); ++q) doubled.force[q] = episode.force[q / 2];
  EXPECT_EQ(classifier.Classify(episode).diagnosis.nearest_cluster,
            classifier.Classify(doubled).diagnosis.nearest_cluster);
}

TEST(Classifier, RefusesAModelAndNamesEveryFault) {
  Model model;
  try {
    const Classifier classifier(model);
    FAIL() << "accepted an empty model";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("no shapelet"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("sample period"), std::string::npos);
  }
}

TEST(Classifier, NamesAClusterAndRefusesOneThatIsNotThere) {
  Classifier classifier(TrainModel(PlantedEpisodes(6, 0, 10), QuickOptions()).model);
  classifier.NameCluster(1, "jammed");
  EXPECT_EQ(classifier.model().EventOf(1), "jammed");
  EXPECT_THROW(classifier.NameCluster(3, "jammed"), std::invalid_argument);
  EXPECT_THROW(classifier.NameCluster(0, ""), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
