// The bounds of every parameter of the segmentation are the same in the validator, the YAML file and the README.
#include "contact_shapelets/core/segmentation_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include "contact_shapelets/core/wrench_stream.h"

namespace contact_shapelets::core {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A parameter with its least and its greatest valid value, and a value beyond each.
struct Bound {
  const char* name;
  double SegmentationOptions::*value;
  double least;
  double greatest;
  double below;
  double beyond;
  const char* row;  ///< least and greatest value in the README
};

std::vector<Bound> Bounds() {
  const auto next = [](double value) { return std::nextafter(value, kInfinity); };
  const auto before = [](double value) { return std::nextafter(value, -kInfinity); };
  using O = SegmentationOptions;
  const double tiny = std::numeric_limits<double>::min();
  return {
      {"sample_period", &O::sample_period, 1e-4, 0.05, before(1e-4), next(1.0), "| 0.0001 | 1 |"},
      {"tare_duration", &O::tare_duration, tiny, 10.0, 0.0, next(10.0), "| above 0 | 10 |"},
      {"min_duration", &O::min_duration, 0.02, before(30.0), before(0.02), 30.0,
       "| 2 sample periods | below max_duration |"},
      {"max_duration", &O::max_duration, next(0.1), 600.0, 0.1, next(600.0), "| above min_duration | 600 |"},
      {"max_gap", &O::max_gap, tiny, before(1.0), 0.0, 1.0, "| above 0 | below stream_timeout |"},
      {"stream_timeout", &O::stream_timeout, next(0.2), 60.0, 0.2, next(60.0), "| above max_gap | 60 |"},
      {"edge_wait", &O::edge_wait, 0.0, 1.0, -tiny, next(1.0), "| 0 | 1 |"},
      {"edge_match_window", &O::edge_match_window, 0.0, 5.0, -tiny, next(5.0), "| 0 | 5 |"},
      {"contact_on", &O::contact_on, next(4.0), 1e6, 4.0, next(1e6), "| above contact_off | 1e6 |"},
      {"contact_off", &O::contact_off, tiny, before(8.0), 0.0, 8.0, "| above 0 | below contact_on |"},
      {"contact_hold_on", &O::contact_hold_on, 0.0, 1.0, -tiny, next(1.0), "| 0 | 1 |"},
      {"contact_hold_off", &O::contact_hold_off, 0.0, 10.0, -tiny, next(10.0), "| 0 | 10 |"},
      {"pre_trigger", &O::pre_trigger, 0.0, 10.0, -tiny, next(10.0), "| 0 | 10 |"},
      {"baseline_duration", &O::baseline_duration, tiny, 60.0, 0.0, next(60.0), "| above 0 | 60 |"},
  };
}

std::string Contents(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Plays some seconds of stream with a contact and edges, which must not crash with any valid parameters.
void Play(const SegmentationOptions& options) {
  WrenchStream stream(options);
  for (int index = 0; index < 400; ++index) {
    const Nanoseconds time = 1'000'000'000 + index * 10'000'000LL;
    stream.AddWrench(time, time, {0.001 * index, 0.0, index > 150 && index < 250 ? 20.0 : 0.0});
    if (index == 100 || index == 300) stream.AddUnstampedEdge(index == 100, time);
    stream.OpenEpisode();
  }
  stream.Finish();
  for (const Episode& episode : stream.TakeEpisodes()) EXPECT_TRUE(episode.force.allFinite());
}

TEST(SegmentationOptions, AcceptTheExtremesOfEveryParameterAndWorkThere) {
  for (const Bound& bound : Bounds()) {
    for (const double value : {bound.least, bound.greatest}) {
      SegmentationOptions options;
      options.*bound.value = value;
      ASSERT_EQ(options.Faults(), "") << bound.name << ' ' << value;
      for (const SegmentationMode mode : {SegmentationMode::kTrigger, SegmentationMode::kContact}) {
        options.segmentation = mode;
        Play(options);
      }
    }
  }
}

TEST(SegmentationOptions, RefuseWhatIsBeyondNotANumberOrInfiniteAndNameIt) {
  for (const Bound& bound : Bounds()) {
    for (const double value : {bound.below, bound.beyond, kNan, kInfinity, -kInfinity, 1e9, -1.0}) {
      SegmentationOptions options;
      options.*bound.value = value;
      // The message about a bound between two parameters may name the other one.
      const std::string faults = options.Faults();
      EXPECT_NE(faults.find(bound.name), std::string::npos) << bound.name << ' ' << value << ": " << faults;
      EXPECT_THROW(WrenchStream{options}, std::invalid_argument);
    }
  }
}

TEST(SegmentationOptions, HaveTheirBoundsInTheReadme) {
  const std::string readme = Contents("README.md");
  for (const Bound& bound : Bounds()) {
    const std::regex row("\\| `" + std::string(bound.name) + "` \\| double \\| [^|]* (\\|[^|]*\\|[^|]*\\|)");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(readme, match, row)) << bound.name;
    EXPECT_EQ(match[1].str(), bound.row) << bound.name;
  }
}

TEST(SegmentationOptions, HaveTheirBoundsInTheParameterFile) {
  const std::string yaml = Contents("config/episode.yaml");
  for (const Bound& bound : Bounds()) {
    const std::regex entry("((?:#[^\n]*\n)+)" + std::string(bound.name) + ":");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(yaml, match, entry)) << bound.name;
    std::smatch parts;
    const std::string row = bound.row;
    ASSERT_TRUE(std::regex_match(row, parts, std::regex(R"(\| (.*) \| (.*) \|)")));
    const std::string comment = std::regex_replace(match[1].str(), std::regex("1000000"), "1e6");
    for (std::size_t part = 1; part <= 2; ++part) {
      // (0, 10] says "above 0" with one sign.
      const std::string words = std::regex_replace(parts[part].str(), std::regex("^above 0$"), "0");
      EXPECT_NE(comment.find(words), std::string::npos) << bound.name << ": " << words << "\nin " << comment;
    }
  }
}

}  // namespace
}  // namespace contact_shapelets::core
