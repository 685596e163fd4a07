#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>

#include "cli/made_bags.h"
#include "cli/program.h"

namespace contact_shapelets::test {
namespace {

constexpr char kQuick[] = "steps: 3\nscales: [0.2, 0.4]\nstart_windows: 300\n";

/// Returns `count` rows with series of 40 samples. Their classes alternate: a hill and a valley, at different places.
std::string Rows(int count) {
  std::ostringstream rows;
  for (int row = 0; row < count; ++row) {
    rows << row % 2 + 1;
    for (int sample = 0; sample < 40; ++sample) {
      const double distance = (sample - 15.0 - row % 7) / 4.0;
      const double noise = 0.02 * std::sin(37.0 * row + 11.0 * sample);
      rows << '\t' << (row % 2 == 0 ? 1.0 : -1.0) * std::exp(-distance * distance) + noise;
    }
    rows << '\n';
  }
  return rows.str();
}

void WriteDataSet(const TemporaryFolder& folder, const std::string& name, const std::string& train) {
  std::filesystem::create_directory(folder / name);
  WriteFile(folder / (name + "/" + name + "_TRAIN.tsv"), train);
  WriteFile(folder / (name + "/" + name + "_TEST.tsv"), Rows(16));
}

/// Returns the JSON without times, which differ from run to run.
std::string WithoutTimes(const std::string& json) {
  return std::regex_replace(json, std::regex("\"fit_seconds\": [^}]*"), "");
}

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Evaluate, GivesTheSameScoresForAnyNumberOfJobs) {
  const TemporaryFolder folder;
  WriteDataSet(folder, "Hills", Rows(20));
  const std::string config = WriteFile(folder / "quick.yaml", kQuick);
  std::string json[2];
  for (const int jobs : {1, 2}) {
    const std::string path = folder / (std::to_string(jobs) + ".json");
    const auto run = RunShapelets({"evaluate", "--data", folder / "", "--datasets", "Hills", "--seeds", "2", "--jobs",
                                   std::to_string(jobs), "--config", config, "--json", path});
    ASSERT_EQ(run.status, 0) << run.err;
    json[jobs - 1] = WithoutTimes(ReadFile(path));
  }
  EXPECT_EQ(json[0], json[1]);
  EXPECT_EQ(Count(json[0], "\"dataset\": \"Hills\""), 8 * 2);
  for (const char* field : {"\"train\": {\"rand_index\": ", "\"test\": {\"rand_index\": ",
                            "\"test_anew\": {\"rand_index\": ", "\"ari\": ", "\"nmi\": ", "\"acc\": "}) {
    EXPECT_GE(Count(json[0], field), 12) << field;
  }
}

TEST(Evaluate, PrintsATableOfMeansDeviationsAndBestsForEachScore) {
  const TemporaryFolder folder;
  WriteDataSet(folder, "Hills", Rows(20));
  const auto run = RunShapelets({"evaluate", "--data", folder / "", "--methods", "kmeans,kshape", "--seeds", "3"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(Count(run.out, "| data set | kmeans | kshape |"), 4);
  // The shape tells a hill from a valley wherever they are.
  EXPECT_NE(run.out.find("1.000 ± 0.000 (1.000) |\n"), std::string::npos) << run.out;
}

TEST(Evaluate, KeepsTheOtherDataSetsIfOneIsBadAndNamesItsFileAndRow) {
  const TemporaryFolder folder;
  WriteDataSet(folder, "Good", Rows(20));
  WriteDataSet(folder, "Short", "1\t0\t1\t2\n1\t0\t2\n");
  WriteDataSet(folder, "Words", "1\t0\t1\t2\n1\t0\tabc\t2\n");
  const auto run = RunShapelets({"evaluate", "--data", folder / "", "--datasets", "Short,Good,Words,Missing",
                                 "--methods", "kmeans", "--json", folder / "out.json"});
  EXPECT_EQ(run.status, 1);
  const std::vector<std::string> lines = Lines(run.err);
  ASSERT_EQ(lines.size(), 3U) << run.err;
  EXPECT_NE(lines[0].find("Short_TRAIN.tsv: row 2: expected 4 columns"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("Words_TRAIN.tsv: row 2: column 3 holds 'abc'"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("Missing_TRAIN.tsv: there is no such file"), std::string::npos) << lines[2];
  EXPECT_EQ(Count(run.out, "| Good |"), 4);
  EXPECT_EQ(Count(ReadFile(folder / "out.json"), "\"dataset\": \"Good\""), 5);
}

TEST(Evaluate, TakesBagsWithOutcomesAsADataSet) {
  const TemporaryFolder folder;
  MadeBag content;
  content.episodes = 12;
  const std::string train = Make(folder / "pushes.bag", content);
  const std::string test = Make(folder / "more.bag", content);
  const std::vector<std::string> common{"evaluate", "--methods", "kmeans", "--seeds", "1", "--bags", train};
  const auto halved = RunShapelets(common);
  EXPECT_EQ(halved.status, 0) << halved.err;
  EXPECT_EQ(Count(halved.out, "| pushes |"), 4) << halved.out;
  std::vector<std::string> separate = common;
  separate.insert(separate.end(), {"--test-bags", test, "--bags-name", "switch push"});
  const auto split = RunShapelets(separate);
  EXPECT_EQ(split.status, 0) << split.err;
  EXPECT_EQ(Count(split.out, "| switch push |"), 4) << split.out;
}

TEST(Evaluate, RefusesBagsWithoutOutcomes) {
  const TemporaryFolder folder;
  MadeBag content;
  content.outcomes = false;
  const std::string bag = Make(folder / "unnamed.bag", content);
  const auto run = RunShapelets({"evaluate", "--methods", "kmeans", "--bags", bag});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("unnamed.bag: expected episodes with an outcome, found none"), std::string::npos) << run.err;
}

TEST(Evaluate, RefusesWrongUsageInOneLine) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"evaluate"},
                                                    {"evaluate", "--data", "x", "--methods", "magic"},
                                                    {"evaluate", "--data", "x", "--methods", ""},
                                                    {"evaluate", "--data", "x", "--datasets", "A,,B"},
                                                    {"evaluate", "--data", "x", "--datasets", "A,"},
                                                    {"evaluate", "--data", "x", "--seeds", "0"}}) {
    const auto run = RunShapelets(arguments);
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(Lines(run.err).size(), 1U) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(Evaluate, RefusesAFolderWithoutDataSets) {
  const TemporaryFolder folder;
  for (const std::string& data : {folder / "", folder / "missing"}) {
    const auto run = RunShapelets({"evaluate", "--data", data, "--methods", "kmeans"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(Lines(run.err).size(), 1U) << run.err;
  }
}

}  // namespace
}  // namespace contact_shapelets::test
