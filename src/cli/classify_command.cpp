#include "cli/classify_command.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <memory>
#include <stdexcept>

#include "cli/common.h"
#include "contact_shapelets/core/parallel.h"
#include "contact_shapelets/ros/conversions.h"
#include "contact_shapelets/ros/model_bag.h"
#include "contact_shapelets/ros/topics.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string model;
  std::string csv;
  std::string annotate;
};

double Seconds(core::Nanoseconds time) { return 1e-9 * static_cast<double>(time); }

void WriteCsv(const std::string& path, const std::vector<core::Episode>& episodes,
              const std::vector<core::Classification>& results) {
  std::ofstream file(path);
  file << "episode_id,start,duration,samples,outcome,cluster,event,confidence,novelty";
  for (Eigen::Index k = 0; k < results.front().features.distances.size(); ++k) file << ",d" << k;
  file << '\n' << std::setprecision(9);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const core::Episode& episode = episodes[index];
    const core::Diagnosis& diagnosis = results[index].diagnosis;
    char start[40];
    std::snprintf(start, sizeof(start), "%.9f", Seconds(episode.start));
    file << episode.id << ',' << start << ',' << episode.duration() << ',' << episode.force.size() << ','
         << episode.outcome << ',' << diagnosis.cluster << ',' << diagnosis.event << ',' << diagnosis.confidence << ','
         << diagnosis.novelty;
    for (const float distance : results[index].features.distances) file << ',' << distance;
    file << '\n';
  }
  file.close();
  if (!file) throw std::runtime_error(path + ": the CSV cannot be written");
}

/// Copies the bags and adds each episode with its features and diagnosis at its end.
void Annotate(const Arguments& arguments, const core::Model& model, const std::vector<core::Episode>& episodes,
              const std::vector<core::Classification>& results) {
  for (const std::string& path : arguments.bags.bags) {
    if (path == arguments.annotate) throw std::runtime_error(path + ": a bag cannot be annotated into itself");
  }
  try {
    rosbag::Bag output(arguments.annotate, rosbag::bagmode::Write);
    for (const std::string& path : arguments.bags.bags) {
      const rosbag::Bag input(path, rosbag::bagmode::Read);
      for (const rosbag::MessageInstance& message : rosbag::View(input)) {
        output.write(message.getTopic(), message.getTime(), message, message.getConnectionHeader());
      }
    }
    for (std::size_t index = 0; index < episodes.size(); ++index) {
      const core::Episode& episode = episodes[index];
      const ros::Time end = ToTime(episode.start) + ros::Duration(episode.duration());
      output.write(topics::kFeatures, end, FeaturesMessage(episode, model, results[index].features));
      output.write(topics::kDiagnosis, end, DiagnosisMessage(episode, model, results[index].diagnosis, true));
    }
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(arguments.annotate + ": the annotated bag cannot be written: " + error.what());
  }
}

void Classify(const Arguments& arguments) {
  const Options options = ReadOptions(arguments.bags);
  const core::Classifier classifier(LoadModel(arguments.model));
  BagReaderOptions reader = options.reader;
  if (arguments.bags.configs.empty()) reader.segmentation.sample_period = classifier.model().sample_period;
  ProgressLine line("reading");
  const std::vector<core::Episode> episodes =
      ReadAllEpisodes(arguments.bags.bags, reader, [&line](double done) { line.Show(done); });
  std::vector<core::Classification> results(episodes.size());
  core::ParallelFor(static_cast<int>(episodes.size()), core::ThreadCount(options.trainer.threads), [&](int index) {
    results[static_cast<std::size_t>(index)] = classifier.Classify(episodes[static_cast<std::size_t>(index)]);
  });

  std::vector<int> clusters;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const core::Diagnosis& diagnosis = results[index].diagnosis;
    clusters.push_back(diagnosis.nearest_cluster);
    std::printf("%s  %-16s confidence %.2f  novelty %.2f  %5.2f s%s%s\n", episodes[index].id.c_str(),
                diagnosis.event.c_str(), diagnosis.confidence, diagnosis.novelty, episodes[index].duration(),
                episodes[index].outcome.empty() ? "" : "  outcome ", episodes[index].outcome.c_str());
  }
  if (!arguments.csv.empty()) WriteCsv(arguments.csv, episodes, results);
  if (!arguments.annotate.empty()) Annotate(arguments, classifier.model(), episodes, results);
  std::printf("%zu episodes\n", episodes.size());
  PrintScores(episodes, clusters);
}

}  // namespace

void AddClassifyCommand(CLI::App* app) {
  CLI::App* command = app->add_subcommand("classify", "Diagnoses the episodes of bags by a model");
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(command, &arguments->bags);
  command->add_option("--model", arguments->model, "The model file")->required();
  command->add_option("--csv", arguments->csv, "Writes one line per episode with all distances");
  command->add_option("--annotate", arguments->annotate, "Writes a copy of the bags with features and diagnoses in it");
  command->callback([arguments] { Classify(*arguments); });
}

}  // namespace contact_shapelets::cli
