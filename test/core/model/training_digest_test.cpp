#include "core/model/training_digest.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/planted_series.h"

namespace contact_shapelets::core {
namespace {

using Change = std::function<void(std::vector<Episode>*, TrainerOptions*)>;

std::string DigestAfter(const Change& change) {
  std::vector<Episode> episodes = PlantedEpisodes(3, 10, 1);
  TrainerOptions options;
  change(&episodes, &options);
  return TrainingDigest(episodes, options);
}

std::string PlainDigest() {
  return DigestAfter([](auto*, auto*) {});
}

TEST(TrainingDigest, IsAsLongAsEver) {
  EXPECT_EQ(PlainDigest().size(), 16U);
  EXPECT_EQ(PlainDigest().find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(TrainingDigest, EachChangedInputGivesAnother) {
  const std::vector<Change> changes{
      [](auto* episodes, auto*) { episodes->pop_back(); },
      [](auto* episodes, auto*) { std::swap(episodes->front(), episodes->back()); },
      [](auto* episodes, auto*) { episodes->front().force.conservativeResize(episodes->front().force.size() - 1); },
      [](auto* episodes, auto*) { (*episodes)[4].force[7] += 0.002F; },
      [](auto* episodes, auto*) {
        for (Episode& episode : *episodes) episode.sample_period = 0.02;
      },
      [](auto*, auto* options) { options->clusters = 4; },
      [](auto*, auto* options) { options->log_distances = false; },
      [](auto*, auto* options) { options->kmeans_restarts = 21; },
      [](auto*, auto* options) { options->voters = 201; },
      [](auto*, auto* options) { options->random_shapelets = 1001; },
      [](auto*, auto* options) { options->voting_episodes = 5001; },
      [](auto*, auto* options) { options->novelty_quantile = 0.99; },
      [](auto*, auto* options) { options->novelty_margin = 1.6; },
      [](auto*, auto* options) { options->seed = 1; },
      [](auto*, auto* options) { options->learner.scales.pop_back(); },
      [](auto*, auto* options) { options->learner.scales[0] = 0.06; },
      [](auto*, auto* options) { options->learner.objective = Objective::kPaper; },
      [](auto*, auto* options) { options->learner.repulsion = 3.1; },
      [](auto*, auto* options) { options->learner.diversity = 0.01; },
      [](auto*, auto* options) { options->learner.sparsity = 0.01; },
      [](auto*, auto* options) { options->learner.flat_fraction = 0.31; },
      [](auto*, auto* options) { options->learner.steps = 61; },
      [](auto*, auto* options) { options->learner.learning_rate = 0.011; },
      [](auto*, auto* options) { options->learner.batch = 129; },
      [](auto*, auto* options) { options->learner.start_windows = 3001; },
      [](auto*, auto* options) { options->learner.shortest = 6; },
  };
  std::set<std::string> digests{PlainDigest()};
  for (std::size_t index = 0; index < changes.size(); ++index) {
    EXPECT_TRUE(digests.insert(DigestAfter(changes[index])).second) << "change " << index;
  }
}

TEST(TrainingDigest, IsTheSameWhereTheModelIs) {
  const std::vector<Change> changes{
      [](auto*, auto* options) { options->threads = 7; },
      [](auto* episodes, auto*) {
        for (Episode& episode : *episodes) episode.outcome = "other";
      },
      [](auto* episodes, auto*) { (*episodes)[2].id = "renamed"; },
  };
  for (const Change& change : changes) EXPECT_EQ(DigestAfter(change), PlainDigest());
}

TEST(TrainingDigest, DoesNotDependOnTheRoundingOfForces) {
  // What another compiler makes of the resampling differs in the last bits.
  const auto force = [](float newtons) {
    return [newtons](auto* episodes, auto*) { (*episodes)[4].force[7] = newtons; };
  };
  EXPECT_EQ(DigestAfter(force(12.3451F)), DigestAfter(force(12.34511F)));
  EXPECT_EQ(DigestAfter(force(0.0F)), DigestAfter(force(-0.0F)));
  EXPECT_NE(DigestAfter(force(12.345F)), DigestAfter(force(12.346F)));
}

TEST(TrainingDigest, IsThatOfAnyMachine) {
  // The value is known from one; it changes with the version of the algorithm alone.
  Episode episode;
  episode.sample_period = 0.01;
  episode.force = Eigen::Vector3f(0.0F, 1.5F, -2.25F);
  EXPECT_EQ(TrainingDigest({episode, episode}, TrainerOptions()), "de3ce00117041c61");
}

}  // namespace
}  // namespace contact_shapelets::core
