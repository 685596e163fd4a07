#include "contact_shapelets/ros/episode_bag_reader.h"

#include <actionlib_msgs/GoalStatusArray.h>

#include <limits>

#include "ros/bags/bag_fixture.h"
#include "ros/messages/conversions.h"

namespace contact_shapelets {
namespace {

using EpisodeBagTest = BagTest;

BagReaderOptions Options(core::SegmentationMode segmentation = core::SegmentationMode::kTrigger) {
  BagReaderOptions options;
  options.segmentation.segmentation = segmentation;
  options.segmentation.tare = core::TareSource::kService;
  return options;
}

/// Three pushes of 1 s at 1 s, 3 s and 5 s, with an outcome after the first and the last.
void WritePushes(const std::string& path) {
  BagWriter bag(path);
  bag.Rising(0.0, 7.0);
  for (const double begin : {1.0, 3.0, 5.0}) {
    bag.Active(begin, true);
    bag.Active(begin + 1.0, false);
  }
  bag.Outcome(2.5, "switched");
  bag.Outcome(6.5, "broken");
}

Episode EpisodeMessage(const std::string& id, int samples, const std::string& outcome = "") {
  Episode message;
  message.header.stamp = At(0.0);
  message.episode_id = id;
  message.sample_period = 0.01;
  message.force.assign(static_cast<std::size_t>(samples), 1.5F);
  message.outcome = outcome;
  return message;
}

TEST_F(EpisodeBagTest, CutsRawWrenchByUnstampedTriggers) {
  WritePushes(Path("pushes.bag"));
  const BagContents contents = ReadEpisodes(Path("pushes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 3U);
  for (std::size_t index = 0; index < 3; ++index) {
    const core::Episode& episode = contents.episodes[index];
    const double begin = 1.0 + 2.0 * static_cast<double>(index);
    EXPECT_EQ(ToTime(episode.start), At(begin));
    EXPECT_EQ(episode.frame_id, "flange");
    EXPECT_TRUE(episode.complete);
    ASSERT_EQ(episode.force.size(), 100);
    for (int value = 0; value < 100; ++value) {
      EXPECT_NEAR(episode.force[value], 10.0 * (begin + 0.01 * (value + 0.5)), 1e-3);
    }
  }
  EXPECT_EQ(contents.stream.samples, 700);
  EXPECT_NEAR(contents.stream.rate, 100.0, 1e-3);
  EXPECT_EQ(contents.dropped_episodes, 0);
}

TEST_F(EpisodeBagTest, OutcomesBelongToTheEpisodeThatClosedLast) {
  WritePushes(Path("pushes.bag"));
  const BagContents contents = ReadEpisodes(Path("pushes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 3U);
  EXPECT_EQ(contents.episodes[0].outcome, "switched");
  EXPECT_EQ(contents.episodes[1].outcome, "");
  EXPECT_EQ(contents.episodes[2].outcome, "broken");
}

TEST_F(EpisodeBagTest, OutcomesOfDroppedEpisodesAndBeforeTheFirstOneBelongToNoEpisode) {
  {
    BagWriter bag(Path("pushes.bag"));
    bag.Rising(0.0, 5.0);
    bag.Outcome(0.5, "too early");
    for (const double begin : {1.0, 3.0}) {
      bag.Active(begin, true);
      bag.Active(begin + 0.5, false);
    }
    bag.Active(2.0, true);
    bag.Active(2.03, false);
    bag.Outcome(2.5, "of the short one");
  }
  const BagContents contents = ReadEpisodes(Path("pushes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 2U);
  EXPECT_EQ(contents.dropped_episodes, 1);
  EXPECT_EQ(contents.episodes[0].outcome, "");
  EXPECT_EQ(contents.episodes[1].outcome, "");
}

TEST_F(EpisodeBagTest, OutcomesBelongToTheirEpisodeIfAllHaveOneName) {
  {
    BagWriter bag(Path("pushes.bag"));
    bag.Rising(0.0, 7.0);
    for (const double begin : {1.0, 3.0, 5.0}) {
      bag.Event(begin, begin, true, "push");
      bag.Event(begin + 1.0, begin + 1.0, false, "push");
      bag.Outcome(begin + 1.5, "outcome of " + std::to_string(std::lround(begin)));
    }
  }
  const BagContents contents = ReadEpisodes(Path("pushes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 3U);
  EXPECT_EQ(contents.episodes[0].outcome, "outcome of 1");
  EXPECT_EQ(contents.episodes[1].outcome, "outcome of 3");
  EXPECT_EQ(contents.episodes[2].outcome, "outcome of 5");
}

/// Three pushes, each with an outcome. The closing of the second is lost.
std::vector<std::string> OutcomesWithALostClosing(const std::string& path, bool stamped) {
  {
    BagWriter bag(path);
    bag.Rising(0.0, 10.0);
    for (const double begin : {1.0, 4.0, 7.0}) {
      for (const double edge : {begin, begin + 1.0}) {
        if (edge == 5.0) continue;
        if (stamped) {
          bag.Event(edge + 0.002, edge, edge == begin);
        } else {
          bag.Active(edge, edge == begin);
        }
      }
      bag.Outcome(begin + 1.5, "outcome of " + std::to_string(std::lround(begin)));
    }
  }
  std::vector<std::string> outcomes;
  for (const core::Episode& episode : ReadEpisodes(path, Options()).episodes) {
    outcomes.push_back((episode.complete ? "" : "incomplete: ") + episode.outcome);
  }
  return outcomes;
}

TEST_F(EpisodeBagTest, TheOutcomeOfAnEpisodeWhoseClosingIsLostDoesNotReplaceThatOfTheEpisodeBefore) {
  EXPECT_EQ(OutcomesWithALostClosing(Path("stamped.bag"), true),
            (std::vector<std::string>{"outcome of 1", "incomplete: ", "outcome of 7"}));
  // Without stamps the second and the third push are one episode.
  EXPECT_EQ(OutcomesWithALostClosing(Path("plain.bag"), false),
            (std::vector<std::string>{"outcome of 1", "incomplete: outcome of 7"}));
}

TEST_F(EpisodeBagTest, AnOutcomeThatComesAfterTheNextOpeningBelongsToTheEpisodeThatIsOver) {
  {
    BagWriter bag(Path("late.bag"));
    bag.Rising(0.0, 5.0);
    for (const double begin : {1.0, 2.5}) {
      bag.Active(begin, true);
      bag.Active(begin + 1.0, false);
    }
    bag.Outcome(3.0, "late");
  }
  const BagContents contents = ReadEpisodes(Path("late.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 2U);
  EXPECT_EQ(contents.episodes[0].outcome, "late");
  EXPECT_EQ(contents.episodes[1].outcome, "");
}

TEST_F(EpisodeBagTest, CutsByStampsIfThereAreSomeAndIgnoresUnstampedTriggers) {
  {
    BagWriter bag(Path("pushes.bag"));
    bag.Rising(0.0, 3.0);
    bag.Active(1.2, true);
    bag.Active(2.2, false);
    bag.Event(1.3, 1.0, true, "push_1");
    bag.Event(2.1, 2.0, false, "push_1");
  }
  const BagContents contents = ReadEpisodes(Path("pushes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 1U);
  EXPECT_EQ(contents.episodes[0].id, "push_1");
  EXPECT_EQ(ToTime(contents.episodes[0].start), At(1.0));
  EXPECT_EQ(contents.episodes[0].force.size(), 100);
  EXPECT_NEAR(contents.episodes[0].force[0], 10.05, 1e-3);
}

TEST_F(EpisodeBagTest, CutsByContact) {
  {
    BagWriter bag(Path("contact.bag"));
    for (int index = 0; index < 500; ++index) bag.Wrench(0.01 * index, index >= 200 && index < 300 ? 20.0 : 0.0);
  }
  const BagContents contents = ReadEpisodes(Path("contact.bag"), Options(core::SegmentationMode::kContact));
  ASSERT_EQ(contents.episodes.size(), 1U);
  EXPECT_EQ(ToTime(contents.episodes[0].start), At(1.5));
  EXPECT_EQ(contents.episodes[0].end_reason, core::EndReason::kContact);
}

TEST_F(EpisodeBagTest, CutsByTheStatusOfAnAction) {
  {
    BagWriter bag(Path("action.bag"));
    bag.Rising(0.0, 3.0);
    for (int index = 0; index < 30; ++index) {
      actionlib_msgs::GoalStatusArray message;
      message.header.stamp = At(0.1 * index);
      message.status_list.resize(1);
      message.status_list[0].status =
          index >= 10 && index < 20 ? actionlib_msgs::GoalStatus::ACTIVE : actionlib_msgs::GoalStatus::SUCCEEDED;
      bag.Any("/push/status", 0.1 * index + 0.002, message);
    }
  }
  const BagContents contents = ReadEpisodes(Path("action.bag"), Options(core::SegmentationMode::kAction));
  ASSERT_EQ(contents.episodes.size(), 1U);
  EXPECT_EQ(ToTime(contents.episodes[0].start), At(1.0));
  EXPECT_EQ(contents.episodes[0].force.size(), 100);
}

TEST_F(EpisodeBagTest, TakesEpisodeMessagesAsTheyAre) {
  {
    BagWriter bag(Path("episodes.bag"));
    bag.Any("/robot/episode", 1.0, EpisodeMessage("first", 20, "given"));
    bag.Outcome(1.5, "said later");
    bag.Any("/robot/episode", 2.0, EpisodeMessage("second", 30));
    bag.Outcome(2.5, "broken");
  }
  const BagContents contents = ReadEpisodes(Path("episodes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 2U);
  EXPECT_EQ(contents.episodes[0].id, "first");
  EXPECT_EQ(contents.episodes[0].force, Eigen::VectorXf::Constant(20, 1.5F));
  EXPECT_EQ(contents.episodes[0].outcome, "given");
  EXPECT_EQ(contents.episodes[1].outcome, "broken");
  EXPECT_EQ(contents.stream.samples, 0);
}

TEST_F(EpisodeBagTest, DropsAndCountsEpisodeMessagesWithoutASeries) {
  {
    BagWriter bag(Path("episodes.bag"));
    bag.Any("/episode", 1.0, EpisodeMessage("empty", 0));
    bag.Any("/episode", 2.0, EpisodeMessage("one", 1));
    bag.Any("/episode", 3.0, EpisodeMessage("well", 20));
  }
  const BagContents contents = ReadEpisodes(Path("episodes.bag"), Options());
  ASSERT_EQ(contents.episodes.size(), 1U);
  EXPECT_EQ(contents.episodes[0].id, "well");
  EXPECT_EQ(contents.dropped_episodes, 2);
}

TEST_F(EpisodeBagTest, DropsAndCountsWrenchesThatAreNotFinite) {
  {
    BagWriter bag(Path("nan.bag"));
    bag.Rising(0.0, 3.0);
    for (int index = 0; index < 10; ++index) bag.Wrench(1.305 + 0.01 * index, std::nan(""));
    bag.Wrench(1.505, -std::numeric_limits<double>::infinity());
    bag.Active(1.0, true);
    bag.Active(2.0, false);
  }
  const BagContents contents = ReadEpisodes(Path("nan.bag"), Options());
  EXPECT_EQ(contents.stream.not_finite, 11);
  EXPECT_EQ(contents.stream.samples, 300);
  ASSERT_EQ(contents.episodes.size(), 1U);
  for (int value = 0; value < 100; ++value) {
    EXPECT_NEAR(contents.episodes[0].force[value], 10.0 * (1.005 + 0.01 * value), 1e-3);
  }
}

TEST_F(EpisodeBagTest, TakesTheWrenchTopicThatWasChosen) {
  {
    BagWriter bag(Path("two.bag"));
    bag.Rising(0.0, 3.0, "/left/wrench");
    for (int index = 0; index < 300; ++index) bag.Wrench(0.01 * index, 7.0, "/right/wrench");
    bag.Active(1.0, true);
    bag.Active(2.0, false);
  }
  BagReaderOptions options = Options();
  for (const std::string name : {"/right/wrench", "right/wrench"}) {
    options.wrench_topic = name;
    EXPECT_NEAR(ReadEpisodes(Path("two.bag"), options).episodes.at(0).force[50], 7.0, 1e-5);
  }
}

TEST_F(EpisodeBagTest, AnOutcomeWithinTheHoldOffBelongsToThatContact) {
  {
    BagWriter bag(Path("contact.bag"));
    for (int index = 0; index < 1500; ++index) {
      const bool contact = index % 500 >= 200 && index % 500 < 300;
      bag.Wrench(0.01 * index, (contact ? 20.0 : 0.0) + 1e-4 * (index % 2));
    }
    for (int push = 0; push < 3; ++push) bag.Outcome(5.0 * push + 3.05, std::to_string(push));
  }
  const BagContents contents = ReadEpisodes(Path("contact.bag"), Options(core::SegmentationMode::kContact));
  ASSERT_EQ(contents.episodes.size(), 3U);
  for (std::size_t push = 0; push < 3; ++push) EXPECT_EQ(contents.episodes[push].outcome, std::to_string(push));
}

TEST_F(EpisodeBagTest, SubtractsTheTareThatWasRecordedAndSaysWhereThereIsNone) {
  for (const bool tared : {true, false}) {
    {
      BagWriter bag(Path("tare.bag"));
      bag.Rising(0.0, 3.0);
      if (tared) bag.Any("/tare", 0.5, TareMessage({0.0, 0.0, 4.0}, 0, "flange"));
      bag.Active(1.0, true);
      bag.Active(2.0, false);
    }
    const BagContents contents = ReadEpisodes(Path("tare.bag"), Options());
    ASSERT_EQ(contents.episodes.size(), 1U);
    EXPECT_NEAR(contents.episodes[0].force[0], tared ? 6.05 : 10.05, 1e-3);
    EXPECT_EQ(contents.stream.episode_faults[static_cast<std::size_t>(core::EpisodeFault::kNotTared)], tared ? 0 : 1);
  }
}

TEST_F(EpisodeBagTest, ReadsSeveralBagsInTheirOrderAndReportsProgress) {
  WritePushes(Path("one.bag"));
  BagWriter(Path("two.bag")).Any("/episode", 1.0, EpisodeMessage("last", 20));
  double last = 0.0;
  const std::vector<core::Episode> episodes =
      ReadAllEpisodes({Path("one.bag"), Path("two.bag")}, Options(), [&last](double part) {
        EXPECT_GE(part, last);
        last = part;
      });
  ASSERT_EQ(episodes.size(), 4U);
  EXPECT_EQ(episodes[3].id, "last");
  EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace contact_shapelets
