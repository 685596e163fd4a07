#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "cli/command.h"
#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/trainer.h"
#include "contact_shapelets/ros/episode_bag_reader.h"

namespace contact_shapelets::cli {

/// Arguments that the commands share: bags, their segmentation, parameter files.
struct BagArguments {
  std::vector<std::string> bags;
  std::string wrench_topic;
  std::string adapter;
  std::string urdf;
  WrenchSource source;
  std::string segmentation;
  std::vector<std::string> configs;
  std::string labels;  ///< a table of outcomes; empty: none
};

/// Returns all files that a command with these arguments reads: bags and parameter files.
std::vector<std::string> FilesRead(const BagArguments& arguments);

/// Adds any number of bags to the positional arguments of a command.
void AddBags(Command* command, std::vector<std::string>* bags);

/// Adds bags and the options of the reader to a command. `arguments` must outlive it.
void AddBagArguments(Command* command, BagArguments* arguments);

/// Adds the option of a table with outcomes.
void AddLabelsOption(Command* command, BagArguments* arguments);

/// Adds only the options of the reader.
void AddReaderOptions(Command* command, BagArguments* arguments);

/// Options of the reader and the trainer.
struct Options {
  BagReaderOptions reader;
  core::TrainerOptions trainer;
};

/// Returns the options by the arguments and their parameter files, else by the `defaults`. \throws std::runtime_error
/// listing every parameter that is out of range or unknown.
Options ReadOptions(const BagArguments& arguments, const core::SegmentationOptions& defaults = {});

/// Reads `options` anew: episodes are cut as those of the model's training were, but for what the arguments and their
/// files set. Prints a warning that names the option and the differences if they set something else.
void FollowPreparation(const core::Model& model, const BagArguments& arguments, Options* options);

/// Prints how many episodes are far from all that the model was trained on, with an example; nothing if none is.
void PrintFarEpisodes(const core::Model& model, const std::vector<core::Episode>& episodes);

/// Reads the episodes of all bags, with the outcomes of the table of labels. Prints progress to stderr and findings
/// about the wrench to stdout. \throws std::runtime_error in one line that names the bag or the table, see
/// ReadEpisodes() and SetOutcomes(). Sets `preparation`, unless it is null, to what the bags have in common.
std::vector<core::Episode> ReadBags(const BagArguments& arguments, const BagReaderOptions& options,
                                    core::Preparation* preparation = nullptr);

/// A line on stderr with the progress and the time to go. On a terminal it overwrites itself.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Shows the part that is done, in [0, 1].
  void Show(double done);
  /// Removes the line from a terminal.
  void Clear();

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_shown_;
  bool terminal_;
  bool shown_ = false;
};

}  // namespace contact_shapelets::cli
