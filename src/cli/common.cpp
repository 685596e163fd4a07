#include "cli/common.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "cli/text.h"
#include "evaluation/partition_metrics.h"
#include "ros/messages/names.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets::cli {

namespace po = boost::program_options;

std::vector<std::string> FilesRead(const BagArguments& arguments) {
  std::vector<std::string> files = arguments.bags;
  files.insert(files.end(), arguments.configs.begin(), arguments.configs.end());
  return files;
}

void AddBags(Command* command, std::vector<std::string>* bags) {
  command->places.add_options()("bags", po::value(bags)->required());
  command->positional.add("bags", -1);
}

void AddReaderOptions(Command* command, BagArguments* arguments) {
  command->options.add_options()("wrench-topic", po::value(&arguments->wrench_topic),
                                 "The topic of the wrench, if a bag has several");
  command->options.add_options()(
      "segmentation",
      po::value(&arguments->segmentation)->notifier(OneOf("--segmentation", {"trigger", "contact", "action"})),
      "What opens and closes an episode: trigger, contact or action");
  command->options.add_options()(
      "config", po::value(&arguments->configs),
      "A YAML file with parameters, such as config/trainer.yaml; give it once for each file");
}

void AddBagArguments(Command* command, BagArguments* arguments) {
  AddBags(command, &arguments->bags);
  AddReaderOptions(command, arguments);
}

Options ReadOptions(const BagArguments& arguments) {
  ParameterReader reader = ParameterReader::FromYaml(arguments.configs);
  Options options;
  options.reader.segmentation = ReadSegmentationOptions(&reader);
  options.trainer = ReadTrainerOptions(&reader);
  reader.Read(parameters::kWrenchTopic, &options.reader.wrench_topic);
  // Users give the nodes' files here too. So a parameter that only a node has is no fault.
  ReadClassifierOptions(&reader);
  double progress_rate = 0.0;
  std::vector<std::string> bags;
  std::string output;
  reader.Read(parameters::kProgressRate, &progress_rate);
  reader.Read(parameters::kBags, &bags);
  reader.Read(parameters::kOutput, &output);
  for (const std::string& name : reader.Unread()) reader.AddFaults(name + " is not a parameter\n");
  std::string faults = reader.Faults();
  if (!faults.empty()) throw std::runtime_error(Joined(arguments.configs, ", ") + ": " + faults);
  if (!arguments.wrench_topic.empty()) options.reader.wrench_topic = arguments.wrench_topic;
  if (arguments.segmentation == "contact") options.reader.segmentation.segmentation = core::SegmentationMode::kContact;
  if (arguments.segmentation == "action") options.reader.segmentation.segmentation = core::SegmentationMode::kAction;
  if (arguments.segmentation == "trigger") options.reader.segmentation.segmentation = core::SegmentationMode::kTrigger;
  return options;
}

std::vector<core::Episode> ReadBags(const std::vector<std::string>& bags, const BagReaderOptions& options) {
  std::vector<core::Episode> episodes;
  ProgressLine line("reading");
  for (std::size_t index = 0; index < bags.size(); ++index) {
    const auto show = [&](double done) {
      line.Show((static_cast<double>(index) + done) / static_cast<double>(bags.size()));
    };
    BagContents contents = ReadEpisodes(bags[index], options, show);
    std::vector<std::string> findings;
    if (contents.stream.samples > 0) {
      for (const core::Finding& finding : core::FindingsOf(contents.stream)) findings.push_back(finding.text);
    }
    if (contents.dropped_episodes > 0) {
      findings.push_back(Count(static_cast<std::size_t>(contents.dropped_episodes), "episode") +
                         " dropped: too short or without a sample");
    }
    const auto incomplete = std::count_if(contents.episodes.begin(), contents.episodes.end(),
                                          [](const core::Episode& episode) { return !episode.complete; });
    if (incomplete > 0) {
      findings.push_back(Count(static_cast<std::size_t>(incomplete), "episode") + " incomplete: samples are missing");
    }
    if (!findings.empty()) {
      line.Clear();
      std::cout << bags[index] << ": " << Joined(findings, "; ") << '\n';
    }
    std::move(contents.episodes.begin(), contents.episodes.end(), std::back_inserter(episodes));
  }
  line.Clear();
  return episodes;
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)),
      start_(std::chrono::steady_clock::now()),
      last_shown_(start_),
      terminal_(isatty(2) == 1) {}

ProgressLine::~ProgressLine() { Clear(); }

void ProgressLine::Clear() {
  if (shown_ && terminal_) std::cerr << "\r\033[K" << std::flush;
  shown_ = false;
}

void ProgressLine::Show(double done) {
  const auto now = std::chrono::steady_clock::now();
  // A log file gets its first line soon, but few lines.
  const auto between = std::chrono::milliseconds(terminal_ ? 200 : shown_ ? 5000 : 1000);
  if (now - last_shown_ < between || done <= 0.0) return;
  last_shown_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  char text[160];
  std::snprintf(text, sizeof(text), "%s%s %3.0f %%, %.0f s to go   %s", terminal_ ? "\r" : "", what_.c_str(),
                100.0 * done, elapsed * (1.0 - done) / done, terminal_ ? "" : "\n");
  std::cerr << text << std::flush;
}

void PrintScores(const std::vector<core::Episode>& episodes, const Eigen::Ref<const Eigen::VectorXi>& labels) {
  const auto result = evaluation::CompareWithOutcomes(labels, episodes);
  if (!result) return;
  std::printf("Against the outcomes given for %zu episodes: Rand index %.4f, ARI %.4f, NMI %.4f, accuracy %.4f\n",
              result->episodes, result->scores.rand_index, result->scores.adjusted_rand_index,
              result->scores.normalised_mutual_information, result->scores.accuracy);
}

}  // namespace contact_shapelets::cli
