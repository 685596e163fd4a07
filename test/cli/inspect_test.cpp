#include <gtest/gtest.h>

#include <filesystem>

#include "cli/made_bags.h"
#include "cli/program.h"

namespace contact_shapelets::test {
namespace {

bool Contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Inspects a bag with this flaw.
std::string InspectFlaw(Flaw flaw) {
  const TemporaryFolder folder;
  MadeBag content;
  content.flaw = flaw;
  const ProgramRun run = RunShapelets({"inspect", Make(folder / "made.bag", content)});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

TEST(InspectTest, SoundBagHasNoFindingAndItsEpisodesAreCounted) {
  const std::string text = InspectFlaw(Flaw::kNone);
  EXPECT_TRUE(Contains(text, "findings: none")) << text;
  EXPECT_TRUE(Contains(text, "1800 over 17.99 s, 100.0 Hz")) << text;
  EXPECT_TRUE(Contains(text, "frame flange")) << text;
  EXPECT_TRUE(Contains(text, "trigger  6 episodes of 2.40 s: 2 broad, 2 double, 2 sharp")) << text;
  EXPECT_TRUE(Contains(text, "/episode_active  std_msgs/Bool, 12 messages: 6 false, 6 true")) << text;
}

TEST(InspectTest, SensorThatRepeatsOneMessageWithItsStampIsFrozen) {
  EXPECT_TRUE(Contains(InspectFlaw(Flaw::kFrozen), "frozen sensor: one value for its whole length"));
}

TEST(InspectTest, SensorThatRepeatsOneForceWithNewStampsIsFrozen) {
  EXPECT_TRUE(Contains(InspectFlaw(Flaw::kFlat), "frozen sensor: one value for its whole length"));
}

TEST(InspectTest, RepeatedMessagesAreCountedAsPartOfAll) {
  const std::string text = InspectFlaw(Flaw::kRepeated);
  // 179 of the 1799 messages after the first.
  EXPECT_TRUE(Contains(text, "repeated samples: 9.95 % equal the sample before, stamp and all")) << text;
  EXPECT_FALSE(Contains(text, "frozen")) << text;
}

TEST(InspectTest, ValuesThatAreNotFiniteAreCounted) {
  EXPECT_TRUE(Contains(InspectFlaw(Flaw::kNotFinite), "36 samples NaN, infinite or above 1e6 N, dropped"));
}

TEST(InspectTest, MissingStampsAreNamed) {
  EXPECT_TRUE(Contains(InspectFlaw(Flaw::kZeroStamps), "1800 samples without a stamp"));
}

TEST(InspectTest, ClockThatIsAnHourBehindIsNamed) {
  const std::string text = InspectFlaw(Flaw::kLateStamps);
  EXPECT_TRUE(Contains(text, "stamps are 3600 s behind the time of arrival")) << text;
  EXPECT_TRUE(Contains(text, "3600.00 s before the time of receipt")) << text;
}

TEST(InspectTest, GapsAreCountedAndDoNotSpoilTheRate) {
  const std::string text = InspectFlaw(Flaw::kGap);
  EXPECT_TRUE(Contains(text, "6 gaps, the longest of 0.51 s")) << text;
  EXPECT_TRUE(Contains(text, "(100.0 Hz), jitter 0.0 ms")) << text;
  EXPECT_TRUE(Contains(text, "6 episodes incomplete: a gap in the wrench (trigger)")) << text;
}

TEST(InspectTest, TwoPublishersOnTheWrenchTopicAreNamed) {
  EXPECT_TRUE(Contains(InspectFlaw(Flaw::kPublishers), "two publishers on one topic: they took turns"));
}

TEST(InspectTest, EveryFindingSaysWhatToDo) {
  const std::string text = InspectFlaw(Flaw::kGap);
  std::size_t findings = 0;
  std::size_t remedies = 0;
  for (const std::string& line : Lines(text.substr(text.find("  findings\n") + 11))) {
    (line.compare(0, 18, "      what to do: ") == 0 ? remedies : findings)++;
  }
  EXPECT_EQ(findings, 2U) << text;
  EXPECT_EQ(remedies, findings) << text;
}

TEST(InspectTest, AbsenceOfMarkersIsNamed) {
  const TemporaryFolder folder;
  MadeBag content;
  content.triggers = false;
  content.outcomes = false;
  const ProgramRun run = RunShapelets({"inspect", Make(folder / "made.bag", content)});
  EXPECT_TRUE(Contains(run.out, "episode markers: none")) << run.out;
  EXPECT_TRUE(Contains(run.out, "use --segmentation contact")) << run.out;
}

TEST(InspectTest, SecondWrenchTopicIsAFindingUnlessOneIsChosen) {
  const TemporaryFolder folder;
  MadeBag content;
  content.wrench_topics = {"/left/wrench", "/right/wrench"};
  const std::string bag = Make(folder / "made.bag", content);
  EXPECT_TRUE(Contains(RunShapelets({"inspect", bag}).out, "several topics of type geometry_msgs/WrenchStamped"));
  const ProgramRun chosen = RunShapelets({"inspect", bag, "--wrench-topic", "/left/wrench"});
  EXPECT_TRUE(Contains(chosen.out, "findings: none")) << chosen.out;
}

TEST(InspectTest, WrenchTopicThatTheBagLacksIsNamedWithThoseThatItHas) {
  const TemporaryFolder folder;
  const std::string bag = Make(folder / "made.bag", MadeBag());
  const std::string text = RunShapelets({"inspect", bag, "--wrench-topic", "/ft_sensor"}).out;
  EXPECT_TRUE(Contains(text, "no topic /ft_sensor of type geometry_msgs/WrenchStamped")) << text;
  EXPECT_TRUE(Contains(text, "choose one with --wrench-topic: /wrench")) << text;
}

TEST(InspectTest, ContactThatIsNeverFoundIsAFindingIfItIsAskedFor) {
  const TemporaryFolder folder;
  MadeBag content;
  content.flaw = Flaw::kFlat;
  const std::string bag = Make(folder / "made.bag", content);
  EXPECT_TRUE(Contains(RunShapelets({"inspect", bag, "--segmentation", "contact"}).out,
                       "/wrench: no contact above contact_on was found in /wrench (contact)"));
}

TEST(InspectTest, UnreadableBagIsNamedAndTheOthersAreInspected) {
  const TemporaryFolder folder;
  const ProgramRun run = RunShapelets({"inspect", folder / "missing.bag", Make(folder / "made.bag", MadeBag())});
  EXPECT_EQ(run.status, 1);
  ASSERT_EQ(Lines(run.err).size(), 1U) << run.err;
  EXPECT_TRUE(Contains(run.err, "missing.bag: expected a bag, but there is no such file")) << run.err;
  EXPECT_TRUE(Contains(run.out, "findings: none")) << run.out;
}

TEST(InspectTest, ModelOfAnotherMessageVersionIsAFinding) {
  const TemporaryFolder folder;
  const ProgramRun run = RunShapelets({"inspect", MakeModelOfAnotherVersion(folder / "old.bag")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(Contains(run.out, "another version")) << run.out;
  EXPECT_TRUE(Contains(run.out, "train again")) << run.out;
}

/// Recordings of a real robot, in the optional data folder beside the package.
class RecordedTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(kFolder)) GTEST_SKIP() << "the optional folder " << kFolder << " is not there";
  }

  std::string InspectRecorded(const std::string& name) {
    const ProgramRun run = RunShapelets({"inspect", kFolder + ("/" + name)});
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  }

 private:
  static constexpr const char* kFolder = "../shared/data/robot/baxter_pick_and_place";
};

TEST_F(RecordedTest, FrozenSensorIsCalledFrozen) {
  const std::string text = InspectRecorded("frozen_sensor.bag");
  EXPECT_TRUE(Contains(text, "frozen sensor: one value for its whole length")) << text;
}

TEST_F(RecordedTest, OnlyRepeatingSensorsAreCalledRepeating) {
  for (const char* const name : {"repeated_samples.bag", "success_1.bag"}) {
    EXPECT_TRUE(Contains(InspectRecorded(name), "repeated samples: 1")) << name;
  }
  for (const char* const name : {"success_2.bag", "anomaly_collision_on_hand.bag", "anomaly_object_displacement.bag"}) {
    const std::string text = InspectRecorded(name);
    EXPECT_FALSE(Contains(text, "repeated samples") || Contains(text, "frozen")) << name << '\n' << text;
  }
}

}  // namespace
}  // namespace contact_shapelets::test
