#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>

#include "cli/made_bags.h"
#include "cli/program.h"
#include "contact_shapelets/Diagnosis.h"
#include "contact_shapelets/ShapeletFeatures.h"
#include "contact_shapelets/core/trainer.h"
#include "contact_shapelets/ros/episode_bag_reader.h"
#include "contact_shapelets/ros/model_bag.h"

namespace contact_shapelets::test {
namespace {

constexpr int kEpisodes = 30;
constexpr char kQuick[] = "steps: 5\nscales: [0.1, 0.2, 0.4]\nstart_windows: 500\n";

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Returns the Rand index by its definition: the part of the pairs that two partitions group alike.
double RandIndex(const std::vector<std::string>& first, const std::vector<std::string>& second) {
  double alike = 0.0;
  double pairs = 0.0;
  for (std::size_t left = 0; left < first.size(); ++left) {
    for (std::size_t right = left + 1; right < first.size(); ++right) {
      alike += (first[left] == first[right]) == (second[left] == second[right]) ? 1.0 : 0.0;
      ++pairs;
    }
  }
  return alike / pairs;
}

std::map<std::string, int> MessagesOf(const std::string& path) {
  const rosbag::Bag bag(path, rosbag::bagmode::Read);
  std::map<std::string, int> counts;
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) ++counts[message.getTopic()];
  return counts;
}

/// Trains one model for all tests, on the first recorded switch pushes.
class OutputsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    bag_ = CutEpisodes("bags/switch_push_train.bag", kEpisodes, *folder_ / "cut.bag");
    model_ = *folder_ / "model.bag";
    training_ =
        RunShapelets({"train", bag_, "--model", model_, "--config", WriteFile(*folder_ / "quick.yaml", kQuick)});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::string bag_;
  static std::string model_;
  static ProgramRun training_;
};

std::unique_ptr<TemporaryFolder> OutputsTest::folder_;
std::string OutputsTest::bag_;
std::string OutputsTest::model_;
ProgramRun OutputsTest::training_;

TEST_F(OutputsTest, TrainingPrintsItsResult) {
  EXPECT_EQ(training_.status, 0) << training_.err;
  EXPECT_NE(training_.out.find("30 episodes of 4.33 s"), std::string::npos) << training_.out;
  EXPECT_NE(training_.out.find("cluster 2: "), std::string::npos) << training_.out;
  EXPECT_NE(training_.out.find("Rand index"), std::string::npos) << training_.out;
  EXPECT_NE(training_.out.find(model_), std::string::npos) << training_.out;
}

TEST_F(OutputsTest, ModelNamesItsSources) {
  const core::Model model = LoadModel(model_);
  EXPECT_EQ(model.clusters.size(), 3U);
  EXPECT_EQ(model.provenance.sources, std::vector<std::string>{bag_});
  EXPECT_EQ(model.provenance.training_episodes, kEpisodes);
  EXPECT_GT(model.provenance.trained, 0);
  const ProgramRun run = RunShapelets({"inspect", model_});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("model " + model.id), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("30 episodes of 4.33 s (median) from " + bag_), std::string::npos) << run.out;
}

TEST_F(OutputsTest, CsvHasTheAgreedColumnsAndOneLinePerEpisode) {
  const std::string csv = *folder_ / "out.csv";
  const ProgramRun run = RunShapelets({"classify", bag_, "--model", model_, "--csv", csv});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> lines = Lines(ReadFile(csv));
  ASSERT_EQ(lines.size(), kEpisodes + 1U);
  std::string head = "episode_id,start,duration,samples,outcome,cluster,event,confidence,novelty,complete";
  const std::size_t shapelets = LoadModel(model_).shapelets.size();
  for (std::size_t index = 0; index < shapelets; ++index) head += ",d" + std::to_string(index);
  EXPECT_EQ(lines.front(), head);
  const std::vector<std::string> cells = Cells(lines[1]);
  ASSERT_EQ(cells.size(), 10 + shapelets);
  EXPECT_EQ(cells[1], "1700000000.000000000");
  EXPECT_DOUBLE_EQ(std::stod(cells[2]), 4.33);
  EXPECT_EQ(cells[3], "433");
  EXPECT_EQ(cells[9], "true");
}

TEST_F(OutputsTest, ClassifyMarksIncompleteEpisodes) {
  MadeBag content;
  content.cut_off = true;
  const std::string bag = Make(*folder_ / "cut_off.bag", content);
  const std::string table = RunShapelets({"classify", bag, "--model", model_}).out;
  EXPECT_NE(table.find("duration  complete  outcome"), std::string::npos) << table;
  EXPECT_NE(table.find(" s  yes "), std::string::npos) << table;
  EXPECT_NE(table.find(" s  no "), std::string::npos) << table;
  EXPECT_EQ(RunShapelets({"classify", bag_, "--model", model_}).out.find("complete"), std::string::npos);
}

TEST_F(OutputsTest, ClassifyEndsWithTheRandIndexOfItsOwnTable) {
  const std::string csv = *folder_ / "scored.csv";
  // The table has no cluster for a novel episode, but the index takes the nearest one. So none may be novel here.
  const ProgramRun run = RunShapelets({"classify", bag_, "--model", model_, "--csv", csv});
  std::vector<std::string> outcomes;
  std::vector<std::string> clusters;
  for (const std::string& line : Lines(ReadFile(csv))) {
    const std::vector<std::string> cells = Cells(line);
    if (cells[0] == "episode_id") continue;
    ASSERT_NE(cells[5], "-1") << line;
    outcomes.push_back(cells[4]);
    clusters.push_back(cells[5]);
  }
  const std::string last = Lines(run.out).back();
  const std::string label = "Rand index ";
  ASSERT_NE(last.find(label), std::string::npos) << last;
  EXPECT_NEAR(std::stod(last.substr(last.find(label) + label.size())), RandIndex(outcomes, clusters), 5e-5) << last;
  EXPECT_NE(last.find("ARI "), std::string::npos) << last;
  EXPECT_NE(last.find("NMI "), std::string::npos) << last;
  EXPECT_NE(run.out.find("events right: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("outcome \\ event"), std::string::npos) << run.out;
}

TEST_F(OutputsTest, AnnotatedBagHoldsTheRecordingAndAResultForEachEpisode) {
  const std::string raw = Make(*folder_ / "raw.bag", MadeBag());
  const std::string annotated = *folder_ / "annotated.bag";
  const ProgramRun run = RunShapelets({"classify", raw, "--model", model_, "--annotate", annotated});
  ASSERT_EQ(run.status, 0) << run.err;
  std::map<std::string, int> expected = MessagesOf(raw);
  for (const char* const topic : {"/features", "/diagnosis", "/event"}) expected[topic] = 6;
  EXPECT_EQ(MessagesOf(annotated), expected);

  const rosbag::Bag bag(annotated, rosbag::bagmode::Read);
  std::vector<std::string> diagnosed;
  std::vector<std::string> events;
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{"/diagnosis", "/event"}));
  for (const rosbag::MessageInstance& message : view) {
    if (const auto diagnosis = message.instantiate<Diagnosis>()) {
      EXPECT_NEAR((message.getTime() - diagnosis->header.stamp).toSec(), 2.4, 0.011);
      EXPECT_TRUE(diagnosis->final);
      diagnosed.push_back(diagnosis->event);
    }
    if (const auto event = message.instantiate<std_msgs::String>()) events.push_back(event->data);
  }
  EXPECT_EQ(diagnosed, events);
}

TEST_F(OutputsTest, EqualSeedsGiveEqualModels) {
  const std::string again = *folder_ / "again.bag";
  ASSERT_EQ(RunShapelets({"train", bag_, "--model", again, "--config", *folder_ / "quick.yaml"}).status, 0);
  EXPECT_EQ(LoadModel(again).id, LoadModel(model_).id);
  ASSERT_EQ(RunShapelets({"train", bag_, "--model", again, "--config", *folder_ / "quick.yaml", "--seed", "7"}).status,
            0);
  EXPECT_NE(LoadModel(again).id, LoadModel(model_).id) << "the older model is still there";
}

TEST_F(OutputsTest, PaperYamlTrainsThePapersSetUp) {
  const std::string bag = CutEpisodes("bags/switch_push_train.bag", 12, *folder_ / "few.bag");
  const std::string path = *folder_ / "paper.bag";
  const ProgramRun run = RunShapelets({"train", bag, "--model", path, "--config", "config/paper.yaml"});
  ASSERT_EQ(run.status, 0) << run.err;
  const core::Model model = LoadModel(path);
  EXPECT_EQ(model.provenance.objective, "paper");
  EXPECT_EQ(model.provenance.selected_scales, std::vector<double>{0.4});
  EXPECT_EQ(model.log_offset, 0.0);
  EXPECT_EQ(model.flat_fraction, 0.0);
  // The evaluation's nn_stne_paper trains by the same options.
  const std::vector<core::Episode> episodes = ReadEpisodes(bag, BagReaderOptions()).episodes;
  EXPECT_EQ(model.id, core::TrainModel(episodes, core::PaperOptions()).model.id);
}

TEST_F(OutputsTest, NumberOfClustersFollowsTheArgument) {
  const std::string two = *folder_ / "two.bag";
  const ProgramRun run =
      RunShapelets({"train", bag_, "--model", two, "--clusters", "2", "--config", *folder_ / "quick.yaml"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(LoadModel(two).clusters.size(), 2U);
}

TEST_F(OutputsTest, DroppedSamplesAreCountedInTheSummary) {
  MadeBag content;
  content.flaw = Flaw::kNotFinite;
  const ProgramRun run = RunShapelets({"classify", Make(*folder_ / "nan.bag", content), "--model", model_});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("nan.bag: 36 samples NaN, infinite or above 1e6 N, dropped"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("nan,"), std::string::npos) << run.out;
}

TEST_F(OutputsTest, ContactSegmentationNeedsNoTrigger) {
  MadeBag content;
  content.triggers = false;
  const ProgramRun run = RunShapelets(
      {"classify", Make(*folder_ / "contact.bag", content), "--model", model_, "--segmentation", "contact"});
  EXPECT_EQ(run.status, 0) << run.err;
  // Two pushes are double: they are below contact_off for longer than contact_hold_off, so they are two contacts each.
  EXPECT_NE(run.out.find("8 episodes by model"), std::string::npos) << run.out;
}

TEST_F(OutputsTest, ReportIsOnePageThatNeedsNoOtherFile) {
  const std::string out = *folder_ / "reports/first";
  const ProgramRun run = RunShapelets({"report", model_, bag_, "--out", out});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = ReadFile(out + "/index.html");
  EXPECT_EQ(page.compare(0, 15, "<!DOCTYPE html>"), 0);
  for (const char* const reference : {"src=", "href=", "http", "@import", "url("}) {
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  }
  const core::Model model = LoadModel(model_);
  EXPECT_NE(page.find(model.id), std::string::npos);
  for (int cluster = 0; cluster < 3; ++cluster) {
    EXPECT_NE(page.find("Cluster " + std::to_string(cluster) + ": " + model.EventOf(cluster)), std::string::npos);
  }
  EXPECT_EQ(page.find("nan"), std::string::npos) << "a figure is not finite";
  EXPECT_EQ(Lines(ReadFile(out + "/episodes.csv")).size(), kEpisodes + 1U);
}

TEST_F(OutputsTest, ReportTakesTheModelByItsOptionAndReplacesItsOwnFiles) {
  const std::string out = *folder_ / "by_option";
  for (int round = 0; round < 2; ++round) {
    const ProgramRun run = RunShapelets({"report", bag_, "--model", model_, "--out", out});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("wrote 30 episodes to " + out + "/index.html"), std::string::npos) << run.out;
  }
}

TEST_F(OutputsTest, ReportListsNovelEpisodes) {
  // These pulses are unlike any push of a switch, and the model has narrow limits.
  const std::string strict = *folder_ / "strict.bag";
  const std::string config =
      WriteFile(*folder_ / "strict.yaml", std::string(kQuick) + "novelty_quantile: 0.05\nnovelty_margin: 1.0\n");
  ASSERT_EQ(RunShapelets({"train", bag_, "--model", strict, "--config", config}).status, 0);
  const std::string raw = Make(*folder_ / "novel.bag", MadeBag());
  const std::string out = *folder_ / "novel";
  ASSERT_EQ(RunShapelets({"report", strict, raw, "--out", out}).status, 0);
  const std::string page = ReadFile(out + "/index.html");
  EXPECT_NE(page.find("<th>novel episode</th>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"n\">10000.100</td>"), std::string::npos);
  // No cluster has the name of these outcomes, so "unknown" is neither right nor wrong.
  EXPECT_EQ(page.find("n right"), std::string::npos);
  EXPECT_EQ(page.find("n wrong"), std::string::npos);
}

TEST_F(OutputsTest, ReportOnEpisodesWithoutOutcomesCallsNoneWrong) {
  MadeBag content;
  content.outcomes = false;
  const std::string out = *folder_ / "unnamed";
  ASSERT_EQ(RunShapelets({"report", model_, Make(*folder_ / "unnamed.bag", content), "--out", out}).status, 0);
  const std::string page = ReadFile(out + "/index.html");
  EXPECT_NE(page.find("The bags have no outcomes to compare with."), std::string::npos);
  EXPECT_EQ(page.find("n wrong"), std::string::npos);
}

}  // namespace
}  // namespace contact_shapelets::test
