// Tests names, outcomes and preparation of models as a user sees them: by the offline program.
#include <gtest/gtest.h>

#include <memory>

#include "cli/made_bags.h"
#include "cli/program.h"
#include "contact_shapelets/ros/episode_bag_reader.h"
#include "contact_shapelets/ros/model_bag.h"

namespace contact_shapelets::test {
namespace {

constexpr char kQuick[] = "steps: 5\nscales: [0.1, 0.2, 0.4]\nstart_windows: 500\n";

/// Trains one model for all tests, on made pushes without outcomes.
class NamesTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    MadeBag content;
    content.episodes = 24;
    content.outcomes = false;
    bag_ = Make(*folder_ / "made.bag", content);
    model_ = *folder_ / "model.bag";
    training_ = RunShapelets({"train", bag_, "--model", model_, "--config", WriteFile(*folder_ / "q.yaml", kQuick)});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static ProgramRun Train(const std::string& model, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"train", bag_, "--model", model, "--config", *folder_ / "q.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunShapelets(arguments);
  }
  /// Writes a table of labels, one for each episode by `outcome_of`.
  template <typename OutcomeOf>
  static std::string Labels(const std::string& name, const OutcomeOf& outcome_of) {
    std::string table = "episode_id,outcome\n";
    const std::vector<core::Episode> episodes = ReadEpisodes(bag_, BagReaderOptions{}).episodes;
    for (std::size_t index = 0; index < episodes.size(); ++index) {
      table += episodes[index].id + "," + outcome_of(index) + "\n";
    }
    return WriteFile(*folder_ / name, table);
  }
  static std::string Kinds(const std::string& name) {
    return Labels(name, [](std::size_t index) { return std::string(1, "abc"[index % 3]); });
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::string bag_;
  static std::string model_;
  static ProgramRun training_;
};

std::unique_ptr<TemporaryFolder> NamesTest::folder_;
std::string NamesTest::bag_;
std::string NamesTest::model_;
ProgramRun NamesTest::training_;

TEST_F(NamesTest, NameListsAndNamesClustersAndKeepsTheOtherNames) {
  const ProgramRun list = RunShapelets({"name", model_});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_NE(list.out.find("cluster 2: "), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("not named"), std::string::npos) << list.out;
  const std::string copy = *folder_ / "copy.bag";
  SaveModel(copy, LoadModel(model_));
  ASSERT_EQ(RunShapelets({"name", copy, "2=broken"}).status, 0);
  const ProgramRun run = RunShapelets({"name", copy, "0=switched", "1=switched"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("episodes, broken"), std::string::npos) << run.out;
  const core::Model model = LoadModel(copy);
  EXPECT_EQ(model.clusters[0].label, "switched");
  EXPECT_EQ(model.clusters[1].label, "switched");
  EXPECT_EQ(model.clusters[2].label, "broken");
}

TEST_F(NamesTest, NameRefusesWhatIsNoClusterOrNoName) {
  EXPECT_EQ(RunShapelets({"name", model_, "7=broken"}).status, 1);
  EXPECT_EQ(RunShapelets({"name", model_, "broken"}).status, 2);
  EXPECT_EQ(RunShapelets({"name", model_, "-1=broken"}).status, 2);
  EXPECT_EQ(RunShapelets({"name", model_, "1=a", "1=b"}).status, 2);
  EXPECT_EQ(RunShapelets({"name", *folder_ / "none.bag"}).status, 1);
}

TEST_F(NamesTest, LabelsGiveOutcomesToABagWithoutThem) {
  const ProgramRun run = Train(*folder_ / "labelled.bag", {"--labels", Kinds("kinds.csv")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("events right: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(" of 24 (unknown 0)"), std::string::npos) << run.out;
  const ProgramRun classified =
      RunShapelets({"classify", bag_, "--model", *folder_ / "labelled.bag", "--labels", *folder_ / "kinds.csv"});
  EXPECT_NE(classified.out.find(" of 24 (unknown "), std::string::npos) << classified.out;
}

TEST_F(NamesTest, LabelsAreRefusedByTheLineThatIsWrong) {
  const std::string id = ReadEpisodes(bag_, BagReaderOptions{}).episodes.front().id;
  const auto refused = [&](const std::string& table, const std::string& words) {
    const ProgramRun run =
        RunShapelets({"classify", bag_, "--model", model_, "--labels", WriteFile(*folder_ / "wrong.csv", table)});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(Lines(run.err).size(), 1U) << run.err;
    EXPECT_NE(run.err.find("wrong.csv, line " + words), std::string::npos) << run.err;
  };
  refused("episode_id,outcome\n" + id + ",a,b\n", "2: expected episode_id,outcome, but found 3 columns");
  refused(id + "\n", "1: expected episode_id,outcome, but found 1 column");
  refused("nobody,a\n", "1: the bags have no episode nobody");
  refused(id + ",a\n\n" + id + ",b\n", "3: episode " + id + " comes twice");
}

TEST_F(NamesTest, NamesMoveToARetrainedModel) {
  const std::string old = *folder_ / "old.bag";
  ASSERT_EQ(Train(old, {"--labels", Kinds("kinds.csv")}).status, 0);
  const core::Model named = LoadModel(old);
  const std::string next = *folder_ / "next.bag";
  const ProgramRun run = Train(next, {"--names-from", old, "--seed", "5"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("takes the name a of the old model"), std::string::npos) << run.out;
  // The same episodes are under the same names, whatever the numbers of the clusters are.
  const ProgramRun right = RunShapelets({"classify", bag_, "--model", next, "--labels", *folder_ / "kinds.csv"});
  EXPECT_NE(right.out.find("events right: 24 of 24"), std::string::npos) << right.out;
}

TEST_F(NamesTest, ANameThatDoesNotMoveIsSaid) {
  const std::string old = *folder_ / "old_stray.bag";
  core::Model stray = LoadModel(model_);
  for (core::Cluster& cluster : stray.clusters) cluster.label.clear();
  // No episode is near to this cluster, so no new cluster can take its name.
  stray.clusters.push_back(stray.clusters.front());
  stray.clusters.back().centroid.setConstant(90.0F);
  stray.clusters.back().label = "never";
  SaveModel(old, stray);
  const ProgramRun run = Train(*folder_ / "not_moved.bag", {"--names-from", old});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("the name never of the old model did not move"), std::string::npos) << run.out;
}

TEST_F(NamesTest, ClassifyCutsAsTheModelsTrainingDid) {
  const std::string contact = *folder_ / "contact.bag";
  ASSERT_EQ(Train(contact, {"--segmentation", "contact"}).status, 0);
  const std::size_t contacts = LoadModel(contact).provenance.training_episodes;
  ASSERT_NE(contacts, 24U) << "two contacts of a double push are two episodes";
  const ProgramRun run = RunShapelets({"classify", bag_, "--model", contact});
  EXPECT_NE(run.out.find(std::to_string(contacts) + " episodes by model"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("warning: --"), std::string::npos) << run.out;
  const ProgramRun quick = RunShapelets({"classify", bag_, "--model", contact, "--config", *folder_ / "q.yaml"});
  EXPECT_EQ(quick.out.find("warning: --"), std::string::npos) << "this file does not say how to cut: " << quick.out;
  const ProgramRun other = RunShapelets({"classify", bag_, "--model", contact, "--segmentation", "trigger"});
  EXPECT_NE(other.out.find("24 episodes by model"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("warning: --segmentation cuts other episodes than the model was trained on: segmentation "
                           "trigger (trained with contact)"),
            std::string::npos)
      << other.out;
}

TEST_F(NamesTest, EpisodesFarFromTheTrainingAreCounted) {
  const ProgramRun far = RunShapelets({"classify", "bags/switch_push_test.bag", "--model", model_});
  EXPECT_NE(far.out.find("far from all training episodes, such as "), std::string::npos) << far.out;
}

}  // namespace
}  // namespace contact_shapelets::test
