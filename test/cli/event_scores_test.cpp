#include "cli/event_scores.h"

#include <gtest/gtest.h>

namespace contact_shapelets::cli {
namespace {

core::Model ModelWithNames(const std::vector<std::string>& names) {
  core::Model model;
  for (const std::string& name : names) {
    core::Cluster cluster;
    cluster.label = name;
    model.clusters.push_back(cluster);
  }
  return model;
}

/// Episodes with outcomes, and the clusters that they are in; -1 is unknown and nearest to cluster 0.
struct Cases {
  std::vector<core::Episode> episodes;
  std::vector<NamedEpisode> named;

  void Add(const core::Model& model, int count, const std::string& outcome, int cluster) {
    for (int index = 0; index < count; ++index) {
      core::Episode episode;
      episode.outcome = outcome;
      episodes.push_back(episode);
      named.push_back({model.EventOf(cluster), std::max(0, cluster)});
    }
  }
};

TEST(EventScoresTest, UnknownIsNeverRight) {
  const core::Model model = ModelWithNames({"switched", "broken"});
  Cases cases;
  cases.Add(model, 4, "switched", -1);
  cases.Add(model, 2, "unknown", -1);
  const EventScores scores(model, cases.episodes, cases.named);
  EXPECT_EQ(scores.Summary(), "events right: 0 of 6 (unknown 6)");
}

TEST(EventScoresTest, SeveralClustersOfOneNameAreAllRight) {
  const core::Model model = ModelWithNames({"switched", "switched", "broken"});
  Cases cases;
  cases.Add(model, 3, "switched", 0);
  cases.Add(model, 4, "switched", 1);
  cases.Add(model, 2, "broken", 2);
  cases.Add(model, 1, "broken", 0);
  cases.Add(model, 1, "broken", -1);
  cases.Add(model, 5, "", 2);
  const EventScores scores(model, cases.episodes, cases.named);
  EXPECT_EQ(scores.Summary(), "events right: 9 of 11 (unknown 1)");
  EXPECT_EQ(scores.outcomes(), (std::vector<std::string>{"broken", "switched"}));
  EXPECT_EQ(scores.events(), (std::vector<std::string>{"broken", "switched", "unknown"}));
  EXPECT_EQ(scores.CountOf("broken", "switched"), 1);
  EXPECT_EQ(scores.CountOf("broken", "unknown"), 1);
  EXPECT_EQ(scores.CountOf("switched", "switched"), 7);
  EXPECT_EQ(scores.CountOf("switched", "broken"), 0);
  EXPECT_EQ(scores.Warnings(), std::vector<std::string>{"note: clusters 0, 1 are all called switched"});
}

TEST(EventScoresTest, WarnsOfANameOfTheMinorityAndOfAnOutcomeWithoutACluster) {
  const core::Model model = ModelWithNames({"rotation", ""});
  Cases cases;
  cases.Add(model, 25, "insertion", 0);
  cases.Add(model, 21, "rotation", 0);
  cases.Add(model, 1, "rotation", 1);
  const EventScores scores(model, cases.episodes, cases.named);
  EXPECT_EQ(scores.Warnings(),
            (std::vector<std::string>{
                "warning: cluster 0 is called rotation, but most of it is insertion (25 insertion, 21 rotation)",
                "warning: no cluster is called insertion (25 episodes)"}));
}

TEST(EventScoresTest, EpisodesWithoutOutcomesGiveNoScoreAndNoWarning) {
  const core::Model model = ModelWithNames({"switched", "switched"});
  Cases cases;
  cases.Add(model, 3, "", 0);
  const EventScores scores(model, cases.episodes, cases.named);
  EXPECT_EQ(scores.episodes(), 0);
  EXPECT_TRUE(scores.Warnings().empty());
  EXPECT_TRUE(scores.Indices().empty());
}

}  // namespace
}  // namespace contact_shapelets::cli
