#include "cli/classify_command.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>

#include "cli/common.h"
#include "cli/episode_table.h"
#include "cli/event_scores.h"
#include "cli/text.h"
#include "cli/text_output.h"
#include "contact_shapelets/ros/model_bag.h"
#include "ros/bags/bag_damage.h"
#include "ros/bags/bag_writer.h"
#include "ros/bags/output_file.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string model;
  std::string csv;
  std::string annotate;
};

/// Adds the messages that the nodes would publish at the end of an episode.
void WriteResult(const core::Episode& episode, const core::Classification& result, const core::Model& model,
                 rosbag::Bag* output) {
  const ros::Time end = ToTime(episode.start) + ros::Duration(episode.duration());
  const auto write = [&](const char* topic, const auto& message) {
    output->write("/" + std::string(topic), end, message);
  };
  std_msgs::String event;
  event.data = result.diagnosis.event;
  write(topics::kFeatures, FeaturesMessage(episode, model, result.features));
  write(topics::kDiagnosis, DiagnosisMessage(episode, model, result.diagnosis, true));
  write(topics::kEvent, event);
}

/// Copies the bags into one, and adds features, diagnosis and event of each episode at its end.
void Annotate(const Arguments& arguments, const core::Model& model, const std::vector<core::Episode>& episodes,
              const std::vector<core::Classification>& results) {
  try {
    OutputFile file(arguments.annotate);
    BagWriter output(file.unfinished());
    for (const std::string& path : arguments.bags.bags) {
      BagDamage damage(path);
      const rosbag::Bag input(path, rosbag::bagmode::Read);
      rosbag::View view(input);
      for (const rosbag::MessageInstance& message : view) {
        output.bag().write(message.getTopic(), message.getTime(), message, message.getConnectionHeader());
      }
    }
    for (std::size_t index = 0; index < episodes.size(); ++index) {
      WriteResult(episodes[index], results[index], model, &output.bag());
    }
    output.Close();
    file.Finish();
  } catch (const std::exception& error) {
    throw std::runtime_error(arguments.annotate + ": the annotated bag cannot be written: " + error.what());
  }
}

void PrintEpisodes(const std::vector<core::Episode>& episodes, const std::vector<core::Classification>& results) {
  std::size_t id_width = 10;
  std::size_t event_width = 5;
  bool outcomes = false;
  bool all_complete = true;
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    id_width = std::max(id_width, episodes[index].id.size());
    event_width = std::max(event_width, results[index].diagnosis.event.size());
    all_complete = all_complete && episodes[index].complete;
    outcomes = outcomes || !episodes[index].outcome.empty();
  }
  std::printf("%s  %s  confidence  novelty  duration%s%s\n", Padded("episode_id", id_width).c_str(),
              Padded("event", event_width).c_str(), all_complete ? "" : "  complete", outcomes ? "  outcome" : "");
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const core::Diagnosis& diagnosis = results[index].diagnosis;
    const char* const complete = all_complete ? "" : episodes[index].complete ? "  yes     " : "  no      ";
    std::printf("%s  %s  %10.2f  %7.2f  %6.2f s%s%s%s\n", Padded(episodes[index].id, id_width).c_str(),
                Padded(diagnosis.event, event_width).c_str(), diagnosis.confidence, diagnosis.novelty,
                episodes[index].duration(), complete, episodes[index].outcome.empty() ? "" : "  ",
                episodes[index].outcome.c_str());
  }
}

void Classify(const Arguments& arguments) {
  Options options = ReadOptions(arguments.bags);
  std::vector<std::string> read = FilesRead(arguments.bags);
  read.push_back(arguments.model);
  if (!arguments.csv.empty()) CheckTextOutput("--csv", arguments.csv, read);
  if (!arguments.annotate.empty()) CheckBagOutput("--annotate", arguments.annotate, read, {arguments.csv});
  const core::Classifier classifier(LoadModel(arguments.model));
  FollowPreparation(classifier.model(), arguments.bags, &options);
  const std::vector<core::Episode> episodes = ReadBags(arguments.bags, options.reader);
  const std::vector<core::Classification> results = ClassifyAll(classifier, episodes, options.trainer.threads);

  PrintEpisodes(episodes, results);
  if (!arguments.csv.empty()) {
    TextOutput csv(arguments.csv);
    WriteCsv(episodes, results, csv.stream());
    csv.Finish();
  }
  if (!arguments.annotate.empty()) Annotate(arguments, classifier.model(), episodes, results);
  std::map<std::string, int> events;
  for (const core::Classification& result : results) ++events[result.diagnosis.event];
  std::printf("%s by model %s: %s\n", Count(episodes.size(), "episode").c_str(), classifier.model().id.c_str(),
              CountsText(events).c_str());
  PrintFarEpisodes(classifier.model(), episodes);
  EventScores(classifier.model(), episodes, NamedEpisodes(results)).Print();
}

}  // namespace

Command ClassifyCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "classify";
  command.description = "Diagnoses the episodes of bags with a model";
  command.usage = "BAG... --model MODEL.bag";
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(&command, &arguments->bags);
  AddLabelsOption(&command, &arguments->bags);
  command.options.add_options()("model", po::value(&arguments->model)->required(), "The model file");
  command.options.add_options()("csv", po::value(&arguments->csv), "Writes one line per episode with all distances");
  command.options.add_options()("annotate", po::value(&arguments->annotate),
                                "Writes a copy of the bags with features, diagnosis and event of each episode");
  command.run = [arguments] {
    Classify(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
