#include "cli/common.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "cli/outcome_labels.h"
#include "cli/text.h"
#include "ros/messages/names.h"
#include "ros/parameters/parameters.h"

namespace contact_shapelets::cli {

namespace po = boost::program_options;

std::vector<std::string> FilesRead(const BagArguments& arguments) {
  std::vector<std::string> files = arguments.bags;
  if (!arguments.urdf.empty()) files.push_back(arguments.urdf);
  if (!arguments.labels.empty()) files.push_back(arguments.labels);
  files.insert(files.end(), arguments.configs.begin(), arguments.configs.end());
  return files;
}

void AddBags(Command* command, std::vector<std::string>* bags) {
  command->places.add_options()("bags", po::value(bags)->required());
  command->positional.add("bags", -1);
}

void AddReaderOptions(Command* command, BagArguments* arguments) {
  command->options.add_options()("wrench-topic", po::value(&arguments->wrench_topic),
                                 "The topic of the wrench, if a bag has several, or if it is not a WrenchStamped");
  command->options.add_options()(
      "adapter", po::value(&arguments->adapter)->notifier(OneOf("--adapter", {"wrench", "joint_torques"})),
      "What the messages of --wrench-topic hold: wrench (in a message of any type) or joint_torques");
  command->options.add_options()("field", po::value(&arguments->source.adapter.field),
                                 "For --adapter: the field with the six numbers, or with the torques");
  command->options.add_options()("urdf", po::value(&arguments->urdf), "For joint_torques: the robot's URDF file");
  command->options.add_options()("base-link", po::value(&arguments->source.adapter.base_link),
                                 "For joint_torques: the first link of the arm");
  command->options.add_options()("tip-link", po::value(&arguments->source.adapter.tip_link),
                                 "For joint_torques: the link at which the wrench acts");
  command->options.add_options()("joint-states", po::value(&arguments->source.joint_states),
                                 "For joint_torques: the topic of the positions (default: /joint_states)");
  command->options.add_options()(
      "segmentation",
      po::value(&arguments->segmentation)->notifier(OneOf("--segmentation", {"trigger", "contact", "action"})),
      "What opens and closes an episode: trigger, contact or action");
  command->options.add_options()(
      "config", po::value(&arguments->configs),
      "A YAML file with parameters, such as config/trainer.yaml; give it once for each file");
}

void AddLabelsOption(Command* command, BagArguments* arguments) {
  command->options.add_options()("labels", po::value(&arguments->labels),
                                 "A CSV table of episode_id,outcome; its outcomes replace those of the bags");
}

void AddBagArguments(Command* command, BagArguments* arguments) {
  AddBags(command, &arguments->bags);
  AddReaderOptions(command, arguments);
}

WrenchSource ReadSource(const BagArguments& arguments) {
  WrenchSource source = arguments.source;
  source.adapter.from_torques = arguments.adapter == "joint_torques";
  if (!source.adapter.from_torques) return source;
  const std::vector<std::pair<const char*, const std::string*>> needed{{"--wrench-topic", &arguments.wrench_topic},
                                                                       {"--urdf", &arguments.urdf},
                                                                       {"--base-link", &source.adapter.base_link},
                                                                       {"--tip-link", &source.adapter.tip_link}};
  for (const auto& [name, value] : needed) {
    if (value->empty()) throw UsageError(std::string("--adapter joint_torques needs ") + name);
  }
  std::ifstream file(arguments.urdf);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(arguments.urdf + ": expected a URDF file, but it cannot be read");
  source.urdf = text.str();
  return source;
}

Options ReadOptions(const BagArguments& arguments, const core::SegmentationOptions& defaults) {
  ParameterReader reader = ParameterReader::FromYaml(arguments.configs);
  Options options;
  options.reader.segmentation = ReadSegmentationOptions(&reader, defaults);
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
  options.reader.source = ReadSource(arguments);
  if (arguments.segmentation == "contact") options.reader.segmentation.segmentation = core::SegmentationMode::kContact;
  if (arguments.segmentation == "action") options.reader.segmentation.segmentation = core::SegmentationMode::kAction;
  if (arguments.segmentation == "trigger") options.reader.segmentation.segmentation = core::SegmentationMode::kTrigger;
  return options;
}

void FollowPreparation(const core::Model& model, const BagArguments& arguments, Options* options) {
  const std::optional<core::SegmentationOptions>& trained = model.preparation.segmentation;
  core::SegmentationOptions defaults = trained.value_or(core::SegmentationOptions());
  defaults.sample_period = model.sample_period;
  defaults.min_duration = std::max(defaults.min_duration, 2.0 * model.sample_period);
  *options = ReadOptions(arguments, defaults);
  if (!trained) return;
  const std::string differences = core::DifferencesOf(options->reader.segmentation, *trained);
  if (differences.empty()) return;
  std::cout << "warning: " << (arguments.segmentation.empty() ? "--config" : "--segmentation")
            << " cuts other episodes than the model was trained on: " << differences << '\n';
}

void PrintFarEpisodes(const core::Model& model, const std::vector<core::Episode>& episodes) {
  std::size_t far = 0;
  std::string example;
  for (const core::Episode& episode : episodes) {
    const std::string why = model.preparation.FarFrom(episode, model.sample_period);
    if (why.empty()) continue;
    if (far++ == 0) example = episode.id + ": " + why;
  }
  if (far == 0) return;
  std::cout << "warning: " << Count(far, "episode") << " far from all training episodes, such as " << example << '\n';
}

std::vector<core::Episode> ReadBags(const BagArguments& arguments, const BagReaderOptions& options,
                                    core::Preparation* preparation) {
  core::Preparation common;
  const std::vector<std::string>& bags = arguments.bags;
  std::vector<core::Episode> episodes;
  ProgressLine line("reading");
  for (std::size_t index = 0; index < bags.size(); ++index) {
    const auto show = [&](double done) {
      line.Show((static_cast<double>(index) + done) / static_cast<double>(bags.size()));
    };
    BagContents contents = ReadEpisodes(bags[index], options, show);
    std::vector<std::string> findings;
    if (contents.stream.samples > 0) {
      core::StreamSummary stream = contents.stream;
      // A gap between episodes is harmless.
      if (stream.episode_faults[static_cast<std::size_t>(core::EpisodeFault::kGap)] == 0) stream.gaps = 0;
      for (const core::Finding& finding : core::FindingsOf(stream)) findings.push_back(finding.text);
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
    common = index == 0 ? contents.preparation : core::InCommon(common, contents.preparation);
    std::move(contents.episodes.begin(), contents.episodes.end(), std::back_inserter(episodes));
  }
  line.Clear();
  if (preparation != nullptr) *preparation = common;
  if (!arguments.labels.empty()) SetOutcomes(arguments.labels, &episodes);
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

}  // namespace contact_shapelets::cli
