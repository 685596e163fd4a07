#include "cli/train_command.h"

#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/common.h"
#include "cli/event_scores.h"
#include "cli/moved_names.h"
#include "cli/text.h"
#include "contact_shapelets/ros/model_bag.h"
#include "ros/bags/output_file.h"
#include "ros/messages/conversions.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string model;
  int clusters = 0;
  int seed = -1;
  bool incomplete = false;
  std::string names_from;
};

/// Removes incomplete episodes and prints their number.
void LeaveOutIncomplete(const Arguments& arguments, const core::TrainerOptions& options,
                        std::vector<core::Episode>* episodes) {
  try {
    const int incomplete = core::TakeIncomplete(options, episodes);
    if (incomplete == 0) return;
    std::printf("Left out of the training as incomplete: %s (use --incomplete to train on them too)\n",
                Count(static_cast<std::size_t>(incomplete), "episode").c_str());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(Joined(arguments.bags.bags, ", ") + ": " + error.what());
  }
}

core::TrainingResult TrainWithProgress(const std::vector<core::Episode>& episodes, const Arguments& arguments,
                                       const core::TrainerOptions& options) {
  ProgressLine line("training on " + Count(episodes.size(), "episode"));
  try {
    return core::TrainModel(episodes, options, [&line](const core::TrainingProgress& progress) {
      line.Show(progress.fraction_done);
      return true;
    });
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(Joined(arguments.bags.bags, ", ") + ": " + error.what());
  }
}

void PrintTraining(const core::TrainingResult& result, const std::vector<core::Episode>& episodes, double seconds) {
  const core::Provenance& provenance = result.model.provenance;
  const std::string outcomes = CountsText(CountOutcomes(episodes));
  std::printf("%s of %.2f s (median)%s%s%s\n", Count(episodes.size(), "episode").c_str(), provenance.typical_duration,
              outcomes.empty() ? "" : ", with outcomes ", outcomes.c_str(),
              outcomes.empty() ? "" : " (not used to learn)");
  std::vector<std::string> scales;
  for (const double scale : provenance.selected_scales) {
    scales.push_back(Number(scale * provenance.typical_duration, 2));
  }
  std::printf("%zu shapelets that started with %s s, %s objective, seed %llu, %.1f s of training\n",
              result.model.shapelets.size(), Joined(scales, ", ").c_str(), provenance.objective.c_str(),
              static_cast<unsigned long long>(provenance.seed), seconds);
}

void PrintClusters(const core::TrainingResult& result, const std::vector<core::Episode>& episodes,
                   const std::string& model_file) {
  bool unnamed = false;
  for (std::size_t index = 0; index < result.model.clusters.size(); ++index) {
    std::map<std::string, int> outcomes;
    for (std::size_t item = 0; item < episodes.size(); ++item) {
      const bool inside = result.labels[static_cast<Eigen::Index>(item)] == static_cast<int>(index);
      if (inside && !episodes[item].outcome.empty()) ++outcomes[episodes[item].outcome];
    }
    const core::Cluster& cluster = result.model.clusters[index];
    unnamed = unnamed || cluster.label.empty();
    std::printf("cluster %zu: %s, event %s%s%s\n", index,
                Count(static_cast<std::size_t>(cluster.size), "episode").c_str(),
                result.model.EventOf(static_cast<int>(index)).c_str(), outcomes.empty() ? "" : ": ",
                CountsText(outcomes).c_str());
  }
  if (unnamed) std::printf("To name cluster 0: shapelets name %s 0=NAME\n", model_file.c_str());
}

void Train(const Arguments& arguments) {
  Options options = ReadOptions(arguments.bags);
  if (arguments.clusters > 0) options.trainer.clusters = arguments.clusters;
  if (arguments.seed >= 0) options.trainer.seed = static_cast<std::uint64_t>(arguments.seed);
  if (arguments.incomplete) options.trainer.incomplete = true;
  std::optional<core::Model> named_model;
  if (!arguments.names_from.empty()) named_model = LoadModel(arguments.names_from);
  CheckModelOutput("--model", arguments.model, FilesRead(arguments.bags));
  core::Preparation preparation;
  std::vector<core::Episode> episodes = ReadBags(arguments.bags, options.reader, &preparation);
  LeaveOutIncomplete(arguments, options.trainer, &episodes);
  const auto start = std::chrono::steady_clock::now();
  core::TrainingResult result = TrainWithProgress(episodes, arguments, options.trainer);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  preparation.SetRanges(episodes);
  result.model.preparation = preparation;
  std::vector<std::string> moved;
  if (named_model) {
    moved = MoveNames(*named_model, episodes, result.labels, options.trainer.threads, &result.model);
  }
  result.model.provenance.sources = arguments.bags.bags;
  result.model.provenance.trained = WallNow();
  SaveModel(arguments.model, result.model);
  PrintTraining(result, episodes, seconds);
  PrintClusters(result, episodes, arguments.model);
  for (const std::string& line : moved) std::printf("%s\n", line.c_str());
  std::printf("Model %s is in %s\n", result.model.id.c_str(), arguments.model.c_str());
  std::vector<NamedEpisode> named;
  for (const int label : result.labels) named.push_back({result.model.EventOf(label), label});
  EventScores(result.model, episodes, named).Print();
}

}  // namespace

Command TrainCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "train";
  command.description = "Learns shapelets and clusters from the episodes of bags";
  command.usage = "BAG... --model OUT.bag";
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(&command, &arguments->bags);
  AddLabelsOption(&command, &arguments->bags);
  command.options.add_options()("model", po::value(&arguments->model)->required(), "The model file to write");
  command.options.add_options()(
      "clusters", po::value(&arguments->clusters)->notifier(InRange("--clusters", 2, core::kMostClusters)),
      "Number of clusters (default: from the config, else 3)");
  command.options.add_options()(
      "seed", po::value(&arguments->seed)->notifier(InRange("--seed", 0, std::numeric_limits<int>::max())),
      "Equal seeds give equal models");
  command.options.add_options()("incomplete", po::bool_switch(&arguments->incomplete),
                                "Learns from incomplete episodes too, such as half a push at the end of a bag");
  command.options.add_options()("names-from", po::value(&arguments->names_from),
                                "An older model, whose names go to the clusters with the same episodes");
  command.run = [arguments] {
    Train(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
