#include "contact_shapelets/ros/parameters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

namespace contact_shapelets {
namespace {

/// Expects that `reader` found each parameter that it read, no other, and each at its default.
void ExpectDefaults(const ParameterReader& reader) {
  EXPECT_EQ(reader.Faults(), "");
  EXPECT_EQ(reader.Unread(), std::vector<std::string>{}) << "in the file, but unknown to the loader";
  EXPECT_EQ(reader.Unset(), std::vector<std::string>{}) << "known to the loader, but missing in the file";
  EXPECT_EQ(reader.Changed(), std::set<std::string>{}) << "the file's value differs from the struct's default";
}

ParameterReader ReaderOf(const std::string& text) {
  const std::string path = testing::TempDir() + "parameters_test.yaml";
  std::ofstream(path) << text;
  return ParameterReader::FromYaml({path});
}

TEST(ShippedParameters, EpisodeFileHoldsEachParameterAtItsDefault) {
  ParameterReader reader = ParameterReader::FromYaml({"config/episode.yaml"});
  ReadEpisodeOptions(&reader);
  ExpectDefaults(reader);
}

TEST(ShippedParameters, TrainerFileHoldsEachParameterAtItsDefault) {
  ParameterReader reader = ParameterReader::FromYaml({"config/trainer.yaml"});
  ReadTrainerOptions(&reader);
  ExpectDefaults(reader);
}

TEST(ShippedParameters, ClassifierFileHoldsEachParameterAtItsDefault) {
  ParameterReader reader = ParameterReader::FromYaml({"config/classifier.yaml"});
  ReadClassifierOptions(&reader);
  ExpectDefaults(reader);
}

TEST(Readme, ListsEachShippedParameterWithItsDefault) {
  std::ifstream readme("README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), std::istreambuf_iterator<char>()};
  for (const std::string file : {"config/episode.yaml", "config/trainer.yaml", "config/classifier.yaml"}) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t colon = line.find(": ");
      if (line.empty() || line.front() == '#' || colon == std::string::npos) continue;
      const std::regex row("\n\\| `" + line.substr(0, colon) + "` \\| [a-z\\[\\]]+ \\| ([^|]*) \\|");
      std::smatch found;
      ASSERT_TRUE(std::regex_search(text, found, row)) << line;
      EXPECT_EQ(found[1], line.substr(colon + 2)) << file;
    }
  }
}

TEST(ParameterReader, ReadsValuesOfEachKind) {
  ParameterReader reader = ReaderOf(
      "sample_period: 1\ntare: free_air\nscales: [0.5, 1]\nobjective: paper\nseed: 7\nearly: false\nmodel: \"12\"\n");
  const EpisodeOptions episode = ReadEpisodeOptions(&reader);
  const core::TrainerOptions trainer = ReadTrainerOptions(&reader);
  const ClassifierOptions classifier = ReadClassifierOptions(&reader);
  EXPECT_EQ(episode.segmentation.sample_period, 1.0);
  EXPECT_EQ(episode.segmentation.tare, core::TareSource::kFreeAir);
  EXPECT_EQ(trainer.learner.scales, (std::vector<double>{0.5, 1.0}));
  EXPECT_EQ(trainer.learner.objective, core::Objective::kPaper);
  EXPECT_EQ(trainer.seed, 7U);
  EXPECT_FALSE(classifier.early);
  EXPECT_EQ(classifier.model, "12");
}

TEST(ParameterReader, NamesWhatDiffersFromTheDefault) {
  ParameterReader reader = ReaderOf("clusters: 5\nkmeans_restarts: 20\nobjective: paper\n");
  ReadTrainerOptions(&reader);
  EXPECT_EQ(reader.Changed(), (std::set<std::string>{"clusters", "objective"}));
}

TEST(ParameterReader, ListsEveryFaultAtOnce) {
  ParameterReader reader = ReaderOf("tare: never\nmax_gap: -1\nmin_duration: soon\nprogress_rate: 1000\n");
  ReadEpisodeOptions(&reader);
  const std::string faults = reader.Faults();
  EXPECT_NE(faults.find("tare must be one of episode_start, free_air, service, but is \"never\""), std::string::npos);
  EXPECT_NE(faults.find("max_gap must be above 0 s, but is -1"), std::string::npos);
  EXPECT_NE(faults.find("min_duration must be a number"), std::string::npos);
  EXPECT_NE(faults.find("progress_rate must be in [0, 100] Hz"), std::string::npos);
}

TEST(ParameterReader, RefusesWhatIsNoSingleWholeNumber) {
  for (const std::string value : {"3.5", "99999999999", "[3]", "{a: 3}", "three", ""}) {
    ParameterReader reader = ReaderOf("clusters: " + value + "\n");
    ReadTrainerOptions(&reader);
    EXPECT_NE(reader.Faults().find("clusters must be a whole number"), std::string::npos) << value;
  }
}

TEST(ParameterReader, NamesWhatNothingRead) {
  ParameterReader reader = ReaderOf("clusters: 3\nclutsers: 4\n");
  ReadTrainerOptions(&reader);
  EXPECT_EQ(reader.Unread(), std::vector<std::string>{"clutsers"});
}

TEST(ParameterReader, NamesAFileThatIsMissing) {
  try {
    ParameterReader::FromYaml({"no/such.yaml"});
    FAIL() << "expected an exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such.yaml"), std::string::npos);
  }
}

}  // namespace
}  // namespace contact_shapelets
