#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "cli/command.h"
#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/trainer.h"
#include "contact_shapelets/ros/episode_bag_reader.h"

namespace contact_shapelets::cli {

/// What the commands share: bags, how to cut them, parameter files.
struct BagArguments {
  std::vector<std::string> bags;
  std::string wrench_topic;
  std::string segmentation;
  std::vector<std::string> configs;
};

/// All files that a command with these reads: bags and parameter files.
std::vector<std::string> FilesRead(const BagArguments& arguments);

/// Adds the bags, as many as are given, to the places of a command.
void AddBags(Command* command, std::vector<std::string>* bags);

/// Adds the bags and the options on how to cut them to a command. `arguments` has to outlive it.
void AddBagArguments(Command* command, BagArguments* arguments);

/// Adds those options alone.
void AddReaderOptions(Command* command, BagArguments* arguments);

/// Options of the reader and the trainer out of the arguments and their parameter files.
struct Options {
  BagReaderOptions reader;
  core::TrainerOptions trainer;
};

/// \throws std::runtime_error listing every parameter that is wrong or unknown.
Options ReadOptions(const BagArguments& arguments);

/// Reads the episodes of all bags, with progress on stderr; says on stdout what is wrong with a bag's wrench.
/// \throws std::runtime_error in one line that names the bag, see ReadEpisodes().
std::vector<core::Episode> ReadBags(const std::vector<std::string>& bags, const BagReaderOptions& options);

/// One line on stderr that is overwritten: what is going on, how far it is, the time to go.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Shows that the part `done` in [0, 1] is done.
  void Show(double done);
  /// Takes the line away from a terminal.
  void Clear();

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_shown_;
  bool terminal_;
  bool shown_ = false;
};

/// How `labels` agree with the outcomes of those episodes that have one; prints a line to stdout, nothing
/// where none has.
void PrintScores(const std::vector<core::Episode>& episodes, const Eigen::Ref<const Eigen::VectorXi>& labels);

}  // namespace contact_shapelets::cli
