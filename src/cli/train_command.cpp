#include "cli/train_command.h"

#include <cstdio>
#include <map>
#include <memory>

#include "cli/common.h"
#include "contact_shapelets/ros/model_bag.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string model;
  int clusters = 0;
  int seed = -1;
};

void PrintClusters(const core::TrainingResult& result, const std::vector<core::Episode>& episodes) {
  for (std::size_t index = 0; index < result.model.clusters.size(); ++index) {
    std::map<std::string, int> outcomes;
    for (std::size_t item = 0; item < episodes.size(); ++item) {
      const bool inside = result.labels[static_cast<Eigen::Index>(item)] == static_cast<int>(index);
      if (inside && !episodes[item].outcome.empty()) ++outcomes[episodes[item].outcome];
    }
    std::printf("cluster %zu: %d episodes, event %s", index, result.model.clusters[index].size,
                result.model.EventOf(static_cast<int>(index)).c_str());
    for (const auto& [outcome, count] : outcomes) std::printf(", %d %s", count, outcome.c_str());
    std::printf("\n");
  }
}

void Train(const Arguments& arguments) {
  Options options = ReadOptions(arguments.bags);
  if (arguments.clusters > 0) options.trainer.clusters = arguments.clusters;
  if (arguments.seed >= 0) options.trainer.seed = static_cast<std::uint64_t>(arguments.seed);
  std::vector<core::Episode> episodes;
  {
    ProgressLine line("reading");
    episodes = ReadAllEpisodes(arguments.bags.bags, options.reader, [&line](double done) { line.Show(done); });
  }
  core::TrainingResult result;
  {
    ProgressLine line("training on " + std::to_string(episodes.size()) + " episodes");
    result = core::TrainModel(episodes, options.trainer, [&line](const core::TrainingProgress& progress) {
      line.Show(progress.fraction_done);
      return true;
    });
  }
  result.model.provenance.sources = arguments.bags.bags;
  SaveModel(arguments.model, result.model);
  std::printf("%zu episodes, %zu shapelets, model %s in %s\n", episodes.size(), result.model.shapelets.size(),
              result.model.id.c_str(), arguments.model.c_str());
  PrintClusters(result, episodes);
  PrintScores(episodes, std::vector<int>(result.labels.data(), result.labels.data() + result.labels.size()));
}

}  // namespace

void AddTrainCommand(CLI::App* app) {
  CLI::App* command = app->add_subcommand("train", "Learns shapelets and clusters from the episodes of bags");
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(command, &arguments->bags);
  command->add_option("--model", arguments->model, "The model file to write")->required();
  command->add_option("--clusters", arguments->clusters, "Number of clusters (default: of the config, 3)")
      ->check(CLI::Range(2, 1000));
  command->add_option("--seed", arguments->seed, "Equal seeds give equal models")->check(CLI::NonNegativeNumber);
  command->callback([arguments] { Train(*arguments); });
}

}  // namespace contact_shapelets::cli
