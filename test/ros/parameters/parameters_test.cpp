#include "ros/parameters/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

namespace contact_shapelets {
namespace {

/// Expects that `reader` found exactly the parameters that it read, each at its default.
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

TEST(ShippedFile, PaperYamlIsTheSetUpThatTheEvaluationComparesWith) {
  ParameterReader reader = ParameterReader::FromYaml({"config/paper.yaml"});
  const core::TrainerOptions read = ReadTrainerOptions(&reader);
  EXPECT_EQ(reader.Faults(), "");
  EXPECT_TRUE(reader.Unread().empty());
  const core::TrainerOptions paper = core::PaperOptions();
  EXPECT_EQ(read.voters, paper.voters);
  EXPECT_EQ(read.log_distances, paper.log_distances);
  EXPECT_EQ(read.learner.objective, paper.learner.objective);
  EXPECT_EQ(read.learner.scales, paper.learner.scales);
  EXPECT_EQ(read.learner.steps, paper.learner.steps);
  EXPECT_EQ(read.learner.diversity, paper.learner.diversity);
  EXPECT_EQ(read.learner.sparsity, paper.learner.sparsity);
  EXPECT_EQ(read.learner.flat_fraction, paper.learner.flat_fraction);
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

TEST(ParameterReader, NamesParametersThatDifferFromTheirDefault) {
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

TEST(ParameterReader, RefusesValuesThatAreNotOneWholeNumber) {
  for (const std::string value : {"3.5", "99999999999", "[3]", "{a: 3}", "three", ""}) {
    ParameterReader reader = ReaderOf("clusters: " + value + "\n");
    ReadTrainerOptions(&reader);
    EXPECT_NE(reader.Faults().find("clusters must be a whole number"), std::string::npos) << value;
  }
}

/// Expects that the reader reads each text as the number beside it.
template <typename Number>
void ExpectRead(const std::map<std::string, Number>& values) {
  for (const auto& [text, expected] : values) {
    ParameterReader reader = ReaderOf("value: " + text + "\n");
    Number value = -1;
    reader.Read("value", &value);
    EXPECT_EQ(value, expected) << text;
    EXPECT_EQ(reader.Faults(), "") << text;
  }
}

TEST(ParameterReader, TakesWholeNumbersByYaml11) {
  const std::map<std::string, int> values{{"010", 8},   {"0b101", 5}, {"0x1F", 31},     {"1_000", 1000},    {"+12", 12},
                                          {"1:30", 90}, {"-0", 0},    {"!!int 12", 12}, {"-2:00:01", -7201}};
  ExpectRead(values);
}

TEST(ParameterReader, TakesNumbersByYaml11) {
  const std::map<std::string, double> values{{"1.0e-2", 0.01},     {"3.", 3.0},         {".5", 0.5},  {"-1_0.5", -10.5},
                                             {"1:30.5", 90.5},     {"2.5E+2", 250.0},   {"010", 8.0}, {"010.0", 10.0},
                                             {"-0:00:30.", -30.0}, {"-.inf", -INFINITY}};
  ExpectRead(values);
}

TEST(ParameterReader, TakesEachSpellingOfTrueAndFalse) {
  for (const std::string text : {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"}) {
    ParameterReader reader = ReaderOf("early: " + text + "\n");
    bool early = false;
    reader.Read("early", &early);
    EXPECT_TRUE(early) << text;
  }
  for (const std::string text : {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"}) {
    ParameterReader reader = ReaderOf("early: " + text + "\n");
    EXPECT_FALSE(ReadClassifierOptions(&reader).early) << text;
  }
}

TEST(ParameterReader, SaysHowToWriteANumberThatRosparamTakesForAText) {
  const std::map<std::string, std::string> spellings{
      {"1e-2", "1.0e-2"}, {"1.5e3", "1.5e+3"}, {"1E5", "1.0e+5"}, {"-.5", "-0.5"}, {"[1, 2e-1]", "2.0e-1"}};
  for (const auto& [text, spelling] : spellings) {
    ParameterReader reader = ReaderOf("value: " + text + "\n");
    double value = -1.0;
    std::vector<double> values;
    text.front() == '[' ? reader.Read("value", &values) : reader.Read("value", &value);
    EXPECT_NE(reader.Faults().find("which rosparam takes for a text: write " + spelling + "\n"), std::string::npos)
        << reader.Faults();
  }
}

TEST(ParameterReader, RefusesOtherTextsAsNumbersWithoutAdvice) {
  for (const std::string text :
       {"soon", "\"5\"", "inf", "089", "0x_", "1.2.3", "99999999999", "!degrees 90", ".", ".e3"}) {
    ParameterReader reader = ReaderOf("value: " + text + "\n");
    double value = -1.0;
    reader.Read("value", &value);
    EXPECT_NE(reader.Faults().find("value must be a number, but is "), std::string::npos) << text;
    EXPECT_EQ(reader.Faults().find("write"), std::string::npos) << text;
  }
}

TEST(ParameterReader, RefusesAMillionDigits) {
  ParameterReader reader = ReaderOf("value: " + std::string(1'000'000, '1') + "\n");
  double value = -1.0;
  reader.Read("value", &value);
  EXPECT_NE(reader.Faults().find("value must be a number"), std::string::npos);
}

TEST(ParameterReader, RefusesAParameterWithoutAValue) {
  for (const std::string text : {"", "~", "null", "{a: 3}"}) {
    ParameterReader reader = ReaderOf("model: " + text + "\n");
    ReadClassifierOptions(&reader);
    EXPECT_EQ(reader.Faults(), "model must be a text, but has no value\n") << text;
  }
}

TEST(ParameterReader, NamesParametersThatNothingRead) {
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
