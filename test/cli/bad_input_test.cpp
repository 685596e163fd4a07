#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>

#include "cli/made_bags.h"
#include "cli/program.h"

namespace contact_shapelets::test {
namespace {

constexpr char kQuick[] = "steps: 2\nscales: [0.1, 0.3]\nstart_windows: 300\nthreads: 1\n";

class BadInputTest : public testing::Test {
 protected:
  /// Expects this exit status, and one line on stderr that holds all `parts`.
  static void ExpectRefusal(const std::vector<std::string>& arguments, int status,
                            const std::vector<std::string>& parts) {
    const ProgramRun run = RunShapelets(arguments);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(Lines(run.err).size(), 1U) << run.err;
    for (const std::string& part : parts) EXPECT_NE(run.err.find(part), std::string::npos) << part << "\n" << run.err;
  }

  /// Expects that the program refuses to train on `bag` and leaves no model.
  void ExpectTrainingRefused(const std::string& bag, const std::vector<std::string>& parts) {
    ExpectRefusal({"train", bag, "--model", model_, "--config", quick_}, 1, parts);
    EXPECT_THROW(ReadFile(model_), std::runtime_error) << "there is a model";
  }

  /// Expects that four runs at the same time all succeed and leave no temporary file.
  void ExpectFourRunsTogether(const std::vector<std::string>& arguments) {
    std::vector<std::thread> runs;
    for (int index = 0; index < 4; ++index) {
      runs.emplace_back([&arguments] { EXPECT_EQ(RunShapelets(arguments).status, 0); });
    }
    for (std::thread& run : runs) run.join();
    for (const std::string& file : folder_.Files()) EXPECT_EQ(file.find(".unfinished"), std::string::npos) << file;
  }

  std::string Sound() { return Make(folder_ / "sound.bag", MadeBag()); }

  TemporaryFolder folder_;
  const std::string model_ = folder_ / "model.bag";
  const std::string quick_ = WriteFile(folder_ / "quick.yaml", kQuick);
};

TEST_F(BadInputTest, MissingBag) { ExpectTrainingRefused(folder_ / "none.bag", {"none.bag", "there is no such file"}); }

TEST_F(BadInputTest, FolderInPlaceOfABag) { ExpectTrainingRefused("/", {"/: expected a bag", "not a file"}); }

TEST_F(BadInputTest, EmptyFile) {
  ExpectTrainingRefused(WriteFile(folder_ / "empty.bag", ""), {"empty.bag", "the file is empty"});
}

TEST_F(BadInputTest, FileOfAnotherKind) {
  ExpectTrainingRefused(WriteFile(folder_ / "text.bag", "hello\n"), {"text.bag", "of another kind"});
}

TEST_F(BadInputTest, BagWithoutAMessage) {
  MadeBag content;
  content.episodes = 0;
  ExpectTrainingRefused(Make(folder_ / "no_message.bag", content),
                        {"no_message.bag", "geometry_msgs/WrenchStamped", "none"});
}

TEST_F(BadInputTest, BagThatWasCutOff) {
  const std::string whole = ReadFile(Sound());
  ExpectTrainingRefused(WriteFile(folder_ / "cut.bag", whole.substr(0, whole.size() / 2)), {"cut.bag", "cut off"});
}

TEST_F(BadInputTest, BagThatIsDamagedWithin) {
  std::string bag = ReadFile(Sound());
  bag.replace(bag.size() - 200, 16, 16, '\xff');
  ExpectTrainingRefused(WriteFile(folder_ / "damaged.bag", bag), {"damaged.bag", "damaged"});
  ExpectRefusal({"inspect", folder_ / "damaged.bag"}, 1, {"damaged.bag", "damaged"});
}

TEST_F(BadInputTest, PartLeftOutOfADamagedBagIsReportedForThatBag) {
  std::string bag = ReadFile(Sound());
  // The first time in the first index comes after the version and the length of the data, 4 bytes each.
  const std::size_t time = bag.find("ver=") + 4 + 4 + 4;
  bag.replace(time, 8, 8, '\0');
  const std::string damaged = WriteFile(folder_ / "damaged.bag", bag);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"inspect", Sound(), damaged}, {"inspect", damaged, folder_ / "none.bag"}}) {
    const ProgramRun run = RunShapelets(arguments);
    ASSERT_FALSE(Lines(run.err).empty());
    EXPECT_NE(Lines(run.err)[0].find("damaged.bag: the bag is damaged, and a part was left out"), std::string::npos)
        << run.err;
  }
  const ProgramRun run = RunShapelets({"inspect", damaged});
  EXPECT_EQ(run.status, 0);
  ASSERT_EQ(Lines(run.err).size(), 1U) << run.err;
  EXPECT_NE(run.err.find("damaged.bag: the bag is damaged, and a part was left out"), std::string::npos) << run.err;
}

TEST_F(BadInputTest, NoWrenchTopic) {
  MadeBag content;
  content.wrench_topics = {};
  ExpectTrainingRefused(Make(folder_ / "no_wrench.bag", content),
                        {"no_wrench.bag", "geometry_msgs/WrenchStamped", "/episode_active (std_msgs/Bool)"});
}

TEST_F(BadInputTest, TwoWrenchTopics) {
  MadeBag content;
  content.wrench_topics = {"/left", "/right"};
  ExpectTrainingRefused(Make(folder_ / "two.bag", content), {"two.bag", "/left, /right", "--wrench-topic"});
}

TEST_F(BadInputTest, WrenchTopicThatIsNotThere) {
  ExpectRefusal({"train", Sound(), "--model", model_, "--wrench-topic", "/other"}, 1,
                {"sound.bag", "/other", "/wrench (geometry_msgs/WrenchStamped)"});
}

TEST_F(BadInputTest, NoEpisode) {
  MadeBag content;
  content.triggers = false;
  ExpectTrainingRefused(Make(folder_ / "no_episode.bag", content), {"no_episode.bag", "episode_active", "contact"});
}

TEST_F(BadInputTest, FewerEpisodesThanClusters) {
  MadeBag content;
  content.episodes = 2;
  ExpectTrainingRefused(Make(folder_ / "few.bag", content), {"few.bag", "episodes (2)", "clusters (3)"});
}

TEST_F(BadInputTest, AllEpisodesFlat) {
  MadeBag content;
  content.flaw = Flaw::kFlat;
  const std::string bag = Make(folder_ / "flat.bag", content);
  ExpectTrainingRefused(bag, {"flat.bag", "at least 3 complete episodes", "6 incomplete ones"});
  ExpectRefusal({"train", bag, "--model", model_, "--config", quick_, "--incomplete"}, 1,
                {"flat.bag", "all episodes are flat"});
}

TEST_F(BadInputTest, ModelThatIsNoBag) {
  ExpectRefusal({"classify", Sound(), "--model", WriteFile(folder_ / "text.bag", "hello\n")}, 1,
                {"text.bag", "another kind"});
}

TEST_F(BadInputTest, ModelThatIsAnotherBag) {
  const std::string bag = Sound();
  ExpectRefusal({"classify", bag, "--model", bag}, 1, {"sound.bag", "contact_shapelets/ShapeletModel", "0"});
}

TEST_F(BadInputTest, ModelOfAnotherMessageVersion) {
  ExpectRefusal({"classify", Sound(), "--model", MakeModelOfAnotherVersion(folder_ / "old.bag")}, 1,
                {"old.bag", "another version", "0123456789abcdef0123456789abcdef"});
}

TEST_F(BadInputTest, AllFaultsOfAParameterFileInOneLine) {
  const std::string config = WriteFile(folder_ / "bad.yaml", "clusters: 0\nsteps: many\nsample_period: 7\nstepps: 3\n");
  ExpectRefusal({"train", Sound(), "--model", model_, "--config", config}, 1,
                {"bad.yaml", "clusters must be in [2, 1000], but is 0", "steps must be a whole number, but is many",
                 "sample_period must be in [0.0001, 1] s, but is 7", "stepps is not a parameter"});
}

TEST_F(BadInputTest, ParameterFileThatIsNotThere) {
  ExpectRefusal({"train", Sound(), "--model", model_, "--config", folder_ / "none.yaml"}, 1,
                {"none.yaml", "cannot be opened"});
}

TEST_F(BadInputTest, EachParameterFileHasItsOwnOptionAndABagMayFollow) {
  const std::string clusters = WriteFile(folder_ / "clusters.yaml", "clusters: 2\n");
  const ProgramRun run = RunShapelets({"train", "--model", model_, "--config", quick_, "--config", clusters, Sound()});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("cluster 1: "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("cluster 2: "), std::string::npos) << run.out;
}

TEST_F(BadInputTest, OutputFolderThatIsNotThereIsNamedBeforeTheWork) {
  ExpectRefusal({"train", Sound(), "--model", folder_ / "none/model.bag"}, 1, {"--model", "there is no folder"});
  ExpectRefusal({"classify", Sound(), "--model", model_, "--csv", folder_ / "none/a.csv"}, 1,
                {"--csv", "there is no folder"});
}

TEST_F(BadInputTest, FilesWithoutPermissionAreNamed) {
  const std::string bag = Sound();
  const std::string table = WriteFile(folder_ / "table.csv", "as it was");
  chmod(table.c_str(), 0400);
  const std::string report = folder_ / "report";
  mkdir(report.c_str(), 0700);
  chmod(WriteFile(report + "/episodes.csv", "as it was").c_str(), 0400);
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  ExpectRefusal({"classify", bag, "--model", model_, "--csv", table}, 1, {"table.csv", "write-protected"});
  ExpectRefusal({"report", model_, bag, "--out", report}, 1, {"--out", "episodes.csv", "write-protected"});
  EXPECT_THROW(ReadFile(report + "/index.html"), std::runtime_error) << "there is half a report";
  chmod(bag.c_str(), 0200);
  ExpectRefusal({"classify", bag, "--model", bag}, 1, {"sound.bag", "Permission denied"});
}

TEST_F(BadInputTest, RecordingIsNeverOverwrittenByAModel) {
  const std::string recording = Sound();
  const std::string before = ReadFile(recording);
  MadeBag content;
  content.episodes = 3;
  const std::string other = Make(folder_ / "other.bag", content);
  ExpectRefusal({"train", recording, "--model", recording}, 1, {"sound.bag", "one of the files that are read"});
  ExpectRefusal({"train", other, "--model", recording}, 1, {"sound.bag", "found another bag"});
  EXPECT_EQ(ReadFile(recording), before);
}

TEST_F(BadInputTest, RecordingThatHoldsAModelIsNotOverwrittenEither) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::string recording = Merge({bag, model_}, folder_ / "recording.bag");
  const std::string before = ReadFile(recording);
  ExpectRefusal({"train", bag, "--model", recording, "--config", quick_}, 1, {"recording.bag", "found another bag"});
  EXPECT_EQ(ReadFile(recording), before);
}

TEST_F(BadInputTest, NoOutputGoesToTheModelOrAnotherInput) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::string model = ReadFile(model_);
  const std::string recording = ReadFile(bag);
  mkdir((folder_ / "report").c_str(), 0700);
  const std::string page = folder_ / "report/index.html";
  ASSERT_EQ(symlink(model_.c_str(), page.c_str()), 0);
  const std::vector<std::string> classify{"classify", bag, "--model", model_, "--config", quick_};
  const auto with = [&classify](const std::string& option, const std::string& path) {
    std::vector<std::string> arguments = classify;
    arguments.insert(arguments.end(), {option, path});
    return arguments;
  };
  for (const std::string& path : {model_, bag, quick_, page}) {
    ExpectRefusal(with("--csv", path), 1, {"--csv", path, "one of the files that are read"});
    ExpectRefusal(with("--annotate", path), 1, {"--annotate", path, "one of the files that are read"});
  }
  ExpectRefusal({"report", model_, bag, "--out", folder_ / "report"}, 1, {"index.html", "files that are read"});
  ExpectRefusal({"train", bag, "--model", quick_, "--config", quick_}, 1, {"quick.yaml", "files that are read"});
  EXPECT_EQ(ReadFile(model_), model);
  EXPECT_EQ(ReadFile(bag), recording);
}

TEST_F(BadInputTest, TwoOutputsDoNotGoToOneFile) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  ExpectRefusal({"classify", bag, "--model", model_, "--csv", folder_ / "x", "--annotate", folder_ / "./x"}, 1,
                {"--annotate", "another output goes to the same file"});
  EXPECT_THROW(ReadFile(folder_ / "x"), std::runtime_error) << "one of them was written";
}

TEST_F(BadInputTest, ATableDoesNotReplaceABag) {
  const std::string bag = Sound();
  const std::string other = Make(folder_ / "other.bag", MadeBag());
  const std::string before = ReadFile(other);
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  ExpectRefusal({"classify", bag, "--model", model_, "--csv", other}, 1, {"--csv", "there is a bag already"});
  EXPECT_EQ(ReadFile(other), before);
}

TEST_F(BadInputTest, AFullDiskLeavesTheOldFiles) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::string report = folder_ / "report";
  ASSERT_EQ(RunShapelets({"report", model_, bag, "--out", report}).status, 0);
  const std::vector<std::string> outputs{folder_ / "table.csv", folder_ / "annotated.bag", report + "/index.html",
                                         report + "/episodes.csv"};
  for (const std::string& output : {outputs[0], outputs[1]}) WriteFile(output, "as it was");
  std::vector<std::string> before;
  for (const std::string& output : outputs) before.push_back(ReadFile(output));
  const std::vector<std::string> files = folder_.Files();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"classify", bag, "--model", model_, "--csv", outputs[0]},
        {"classify", bag, "--model", model_, "--annotate", outputs[1]},
        {"report", model_, bag, "--out", report}}) {
    // Enough for the episodes' table within the report, not for its page.
    const ProgramRun run = RunShapeletsWithLittleSpace(arguments, arguments[0] == "report" ? 8192 : 300);
    EXPECT_EQ(run.status, 1) << arguments[0];
    EXPECT_NE(run.err.find("cannot be written"), std::string::npos) << run.err;
  }
  for (std::size_t index = 0; index < outputs.size(); ++index) {
    EXPECT_EQ(ReadFile(outputs[index]), before[index]) << outputs[index];
  }
  EXPECT_EQ(folder_.Files(), files);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(report), std::filesystem::directory_iterator()), 2);
}

TEST_F(BadInputTest, ADiskThatFillsUpAnywhereInABagEndsInOneLine) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::vector<std::string> files = folder_.Files();
  for (const unsigned long bytes : {5000UL, 20480UL, 60000UL}) {
    const ProgramRun run =
        RunShapeletsWithLittleSpace({"classify", bag, "--model", model_, "--annotate", folder_ / "a.bag"}, bytes);
    EXPECT_EQ(run.status, 1) << bytes << run.err;
    EXPECT_EQ(Lines(run.err).size(), 1U) << bytes << run.err;
    EXPECT_EQ(folder_.Files(), files) << bytes;
  }
}

TEST_F(BadInputTest, AnnotationEndedByASignalLeavesNothing) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::vector<std::string> files = folder_.Files();
  // Long enough to be interrupted.
  std::vector<std::string> arguments{"classify", "--model", model_, "--annotate", folder_ / "annotated.bag"};
  arguments.insert(arguments.end(), 60, bag);
  for (const int number : {SIGINT, SIGTERM}) {
    ASSERT_TRUE(EndShapeletsOnceItWrites(arguments, folder_.path(), "annotated.bag", number)) << number;
    EXPECT_EQ(folder_.Files(), files) << number;
  }
  ASSERT_TRUE(EndShapeletsOnceItWrites(arguments, folder_.path(), "annotated.bag", SIGKILL));
  ASSERT_EQ(RunShapelets({"classify", bag, "--model", model_, "--annotate", folder_ / "annotated.bag"}).status, 0);
  std::vector<std::string> after = files;
  after.insert(std::lower_bound(after.begin(), after.end(), "annotated.bag"), "annotated.bag");
  EXPECT_EQ(folder_.Files(), after) << "what a killed run left was not removed";
}

TEST_F(BadInputTest, EpisodesThatLackSamplesAreLeftOutOfTrainingUnlessAskedFor) {
  // The last push goes on when the recording ends.
  MadeBag content;
  content.cut_off = true;
  const std::string bag = Make(folder_ / "cut_off.bag", content);
  const ProgramRun run = RunShapelets({"train", bag, "--model", model_, "--config", quick_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("Left out of the training as incomplete: 1 episode"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("5 episodes of "), std::string::npos) << run.out;
  const ProgramRun all = RunShapelets({"train", bag, "--model", model_, "--config", quick_, "--incomplete"});
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_NE(all.out.find("6 episodes of "), std::string::npos) << all.out;
  EXPECT_EQ(all.out.find("Left out"), std::string::npos) << all.out;
  const std::string config = WriteFile(folder_ / "incomplete.yaml", std::string(kQuick) + "incomplete: true\n");
  EXPECT_NE(RunShapelets({"train", bag, "--model", model_, "--config", config}).out.find("6 episodes of "),
            std::string::npos);
}

TEST_F(BadInputTest, WrongUsageExitsWithTwo) {
  const std::string bag = Sound();
  ExpectRefusal({}, 2, {"train, classify"});
  ExpectRefusal({"learn"}, 2, {"train, classify", "learn"});
  ExpectRefusal({"train", bag}, 2, {"--model"});
  ExpectRefusal({"train", bag, "--model", model_, "--clusters", "1"}, 2, {"--clusters", "1"});
  ExpectRefusal({"train", bag, "--model", model_, "--segmentation", "guess"}, 2, {"--segmentation", "guess"});
  ExpectRefusal({"classify", "--model", model_}, 2, {"bags"});
  ExpectRefusal({"report", model_, "--out", folder_ / "out"}, 2, {"bags"});
  ExpectRefusal({"inspect", bag, "--loud"}, 2, {"--loud"});
  ExpectRefusal({"train", "--bags", bag, "--model", model_}, 2, {"expected BAG... --model", "--bags"});
  ExpectRefusal({"clasify", bag}, 2, {"did you mean classify?"});
  ExpectRefusal({"train", bag, "--modle", model_}, 2, {"did you mean --model?"});
}

TEST_F(BadInputTest, AReportReplacesNoFileOfAnotherKind) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::string report = folder_ / "page";
  mkdir(report.c_str(), 0700);
  WriteFile(report + "/index.html", "<html>my page</html>");
  ExpectRefusal({"report", model_, bag, "--out", report}, 1, {"index.html", "not of a report"});
  EXPECT_EQ(ReadFile(report + "/index.html"), "<html>my page</html>");
}

TEST_F(BadInputTest, HelpIsNoError) {
  const ProgramRun run = RunShapelets({"train", "--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("--model"), std::string::npos);
}

TEST_F(BadInputTest, FailedTrainingLeavesTheOldModel) {
  ASSERT_EQ(RunShapelets({"train", Sound(), "--model", model_, "--config", quick_}).status, 0);
  const std::string before = ReadFile(model_);
  MadeBag content;
  content.flaw = Flaw::kFlat;
  EXPECT_EQ(RunShapelets({"train", Make(folder_ / "flat.bag", content), "--model", model_}).status, 1);
  EXPECT_EQ(ReadFile(model_), before);
}

TEST_F(BadInputTest, ResultsThatCannotBeWrittenToStdoutAreAnError) {
  const ProgramRun run = RunShapeletsWithoutSpace({"inspect", Sound()});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(Lines(run.err).size(), 1U) << run.err;
}

TEST_F(BadInputTest, TrainingsThatEndTogetherLeaveOneWholeModel) {
  const std::string bag = Sound();
  ExpectFourRunsTogether({"train", bag, "--model", model_, "--config", quick_});
  EXPECT_EQ(RunShapelets({"classify", bag, "--model", model_}).status, 0);
}

TEST_F(BadInputTest, AnnotationsThatEndTogetherLeaveOneWholeBag) {
  const std::string bag = Sound();
  const std::string annotated = folder_ / "annotated.bag";
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  ExpectFourRunsTogether({"classify", bag, "--model", model_, "--annotate", annotated});
  EXPECT_EQ(RunShapelets({"classify", annotated, "--model", model_}).status, 0);
}

TEST_F(BadInputTest, TrainingEndedByASignalLeavesTheOldModelAndNothingElse) {
  const std::string bag = Sound();
  ASSERT_EQ(RunShapelets({"train", bag, "--model", model_, "--config", quick_}).status, 0);
  const std::string before = ReadFile(model_);
  const std::vector<std::string> files = folder_.Files();
  const std::string endless = WriteFile(folder_ / "quick.yaml", "steps: 1000000\nscales: [0.1, 0.3]\nthreads: 1\n");
  for (const int number : {SIGKILL, SIGTERM, SIGINT}) {
    ASSERT_TRUE(EndShapeletsAfter({"train", bag, "--model", model_, "--config", endless}, "to go", number)) << number;
    EXPECT_EQ(ReadFile(model_), before) << number;
    EXPECT_EQ(folder_.Files(), files) << number;
  }
}

}  // namespace
}  // namespace contact_shapelets::test
