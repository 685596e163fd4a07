/// replay.launch plays a recorded bag through the nodes in simulated time. The results equal those of the offline
/// program.

#include <contact_shapelets/Diagnosis.h>
#include <contact_shapelets/Episode.h>
#include <contact_shapelets/ShapeletFeatures.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/ros/episode_bag_reader.h"
#include "contact_shapelets/ros/model_bag.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

std::string Parameter(const std::string& name) {
  std::string value;
  EXPECT_TRUE(ros::param::get("/replay/" + name, value)) << name;
  return value;
}

/// The results of the nodes for a bag that loops, and those of the offline classes.
class Replay : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Inbox<Episode> episodes("episode");
    Inbox<ShapeletFeatures> features("features");
    Inbox<Diagnosis> diagnoses("diagnosis");
    Inbox<std_msgs::String> events("event");
    ASSERT_TRUE(episodes.WaitForPublisher() && features.WaitForPublisher() && diagnoses.WaitForPublisher() &&
                events.WaitForPublisher());
    expected_ = ReadEpisodes(Parameter("bag"), BagReaderOptions()).episodes;
    const core::Classifier classifier(LoadModel(Parameter("model")));
    for (const core::Episode& episode : expected_) results_.push_back(classifier.Classify(episode));
    // The player waits for this subscriber, so it starts when everything is connected.
    const Inbox<std_msgs::String> outcomes("outcome");
    const std::size_t once = expected_.size();
    ASSERT_TRUE(WaitUntil([&] { return features.messages().size() >= once + 2; }, 120.0));
    episodes_ = episodes.messages();
    features_ = features.messages();
    events_ = events.messages();
    for (const Diagnosis& diagnosis : diagnoses.messages()) {
      (diagnosis.final ? diagnoses_ : early_).push_back(diagnosis);
    }
  }

  static std::vector<core::Episode> expected_;
  static std::vector<core::Classification> results_;
  static std::vector<Episode> episodes_;
  static std::vector<ShapeletFeatures> features_;
  static std::vector<Diagnosis> diagnoses_;
  static std::vector<Diagnosis> early_;
  static std::vector<std_msgs::String> events_;
};

std::vector<core::Episode> Replay::expected_;
std::vector<core::Classification> Replay::results_;
std::vector<Episode> Replay::episodes_;
std::vector<ShapeletFeatures> Replay::features_;
std::vector<Diagnosis> Replay::diagnoses_;
std::vector<Diagnosis> Replay::early_;
std::vector<std_msgs::String> Replay::events_;

TEST_F(Replay, GivesTheEpisodesOfTheBagToTheLastSample) {
  ASSERT_EQ(expected_.size(), 12U);
  ASSERT_GE(episodes_.size(), expected_.size());
  for (std::size_t index = 0; index < expected_.size(); ++index) {
    const core::Episode& expected = expected_[index];
    EXPECT_EQ(episodes_[index].episode_id, expected.id);
    EXPECT_TRUE(episodes_[index].complete);
    ASSERT_EQ(static_cast<Eigen::Index>(episodes_[index].force.size()), expected.force.size());
    for (Eigen::Index sample = 0; sample < expected.force.size(); ++sample) {
      ASSERT_NEAR(episodes_[index].force[static_cast<std::size_t>(sample)], expected.force[sample], 1e-6);
    }
  }
}

TEST_F(Replay, GivesTheDistancesOfTheOfflineProgram) {
  ASSERT_GE(features_.size(), results_.size());
  for (std::size_t index = 0; index < results_.size(); ++index) {
    const core::ShapeletDistances& expected = results_[index].features;
    ASSERT_EQ(static_cast<Eigen::Index>(features_[index].distances.size()), expected.distances.size());
    for (Eigen::Index k = 0; k < expected.distances.size(); ++k) {
      EXPECT_NEAR(features_[index].distances[static_cast<std::size_t>(k)], expected.distances[k], 1e-6);
      EXPECT_NEAR(features_[index].memberships[static_cast<std::size_t>(k)], expected.memberships[k], 1e-6);
    }
  }
}

TEST_F(Replay, GivesTheDiagnosesOfTheOfflineProgramAndMostOfThemAreRight) {
  ASSERT_GE(diagnoses_.size(), results_.size());
  ASSERT_GE(events_.size(), results_.size());
  int right = 0;
  for (std::size_t index = 0; index < results_.size(); ++index) {
    EXPECT_EQ(diagnoses_[index].episode_id, expected_[index].id);
    EXPECT_EQ(diagnoses_[index].cluster, results_[index].diagnosis.cluster);
    EXPECT_EQ(diagnoses_[index].event, results_[index].diagnosis.event);
    right += diagnoses_[index].event == expected_[index].outcome ? 1 : 0;
    EXPECT_NEAR(diagnoses_[index].confidence, results_[index].diagnosis.confidence, 1e-5);
    EXPECT_EQ(events_[index].data, diagnoses_[index].event);
  }
  EXPECT_GE(right, 10) << "of " << results_.size() << ", by a model that was trained in a second";
}

TEST_F(Replay, DiagnosesOpenEpisodesEarly) {
  ASSERT_FALSE(early_.empty());
  for (const Diagnosis& diagnosis : early_) {
    const auto same = [&](const core::Episode& episode) { return episode.id == diagnosis.episode_id; };
    EXPECT_EQ(std::count_if(expected_.begin(), expected_.end(), same), 1);
  }
}

TEST_F(Replay, GivesTheSameAgainWhenTheBagLoops) {
  const std::size_t once = expected_.size();
  ASSERT_GE(features_.size(), once + 2);
  for (std::size_t index = 0; index < 2; ++index) {
    EXPECT_EQ(features_[once + index].episode_id, features_[index].episode_id);
    EXPECT_EQ(features_[once + index].distances, features_[index].distances);
  }
}

}  // namespace
}  // namespace contact_shapelets::test
