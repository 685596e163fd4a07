#include "cli/common.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <map>
#include <stdexcept>

#include "contact_shapelets/ros/parameters.h"

namespace contact_shapelets::cli {

void AddBagArguments(CLI::App* command, BagArguments* arguments) {
  command->add_option("bags", arguments->bags, "Recorded bags: raw wrench with triggers, or Episode messages")->required();
  command->add_option("--wrench-topic", arguments->wrench_topic, "The wrench, where it is not the only WrenchStamped");
  command->add_option("--segmentation", arguments->segmentation, "What opens and closes an episode")
      ->check(CLI::IsMember({"trigger", "contact", "action"}));
  command->add_option("--config", arguments->configs, "YAML files with parameters, such as config/trainer.yaml");
}

Options ReadOptions(const BagArguments& arguments) {
  ParameterReader reader = ParameterReader::FromYaml(arguments.configs);
  Options options;
  options.reader.segmentation = ReadSegmentationOptions(&reader);
  options.trainer = ReadTrainerOptions(&reader);
  options.reader.wrench_topic = arguments.wrench_topic;
  for (const std::string& name : reader.Unread()) reader.AddFaults(name + " is not a parameter; ");
  std::string faults = reader.Faults();
  if (!faults.empty()) {
    for (char& letter : faults) letter = letter == '\n' ? ';' : letter;
    throw std::runtime_error("parameters: " + faults);
  }
  if (arguments.segmentation == "contact") options.reader.segmentation.segmentation = core::Segmentation::kContact;
  if (arguments.segmentation == "action") options.reader.segmentation.segmentation = core::Segmentation::kAction;
  if (arguments.segmentation == "trigger") options.reader.segmentation.segmentation = core::Segmentation::kTrigger;
  return options;
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), start_(std::chrono::steady_clock::now()), last_shown_(start_), terminal_(isatty(2) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_ && terminal_) std::cerr << '\n';
}

void ProgressLine::Show(double done) {
  const auto now = std::chrono::steady_clock::now();
  const auto between = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(5000);
  if (now - last_shown_ < between || done <= 0.0) return;
  last_shown_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  char text[160];
  std::snprintf(text, sizeof(text), "%s%s %3.0f %%, %.0f s to go   %s", terminal_ ? "\r" : "", what_.c_str(),
                100.0 * done, elapsed * (1.0 - done) / done, terminal_ ? "" : "\n");
  std::cerr << text << std::flush;
}

void PrintScores(const std::vector<core::Episode>& episodes, const std::vector<int>& labels) {
  std::map<std::string, int> classes;
  std::vector<int> used;
  std::vector<int> given;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    if (episodes[index].outcome.empty()) continue;
    used.push_back(labels[index]);
    given.push_back(classes.emplace(episodes[index].outcome, static_cast<int>(classes.size())).first->second);
  }
  if (used.size() < 2) return;
  const core::PartitionScores scores =
      core::ComparePartitions(Eigen::Map<const Eigen::VectorXi>(used.data(), static_cast<Eigen::Index>(used.size())),
                              Eigen::Map<const Eigen::VectorXi>(given.data(), static_cast<Eigen::Index>(given.size())));
  std::printf("Against the outcomes given for %zu episodes: Rand index %.4f, ARI %.4f, NMI %.4f, accuracy %.4f\n",
              used.size(), scores.rand_index, scores.adjusted_rand_index, scores.normalised_mutual_information,
              scores.accuracy);
}

}  // namespace contact_shapelets::cli
