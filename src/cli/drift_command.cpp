#include "cli/drift_command.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/common.h"
#include "cli/episode_table.h"
#include "cli/text.h"
#include "cli/text_output.h"
#include "contact_shapelets/ros/model_bag.h"
#include "core/drift/run_monitor.h"
#include "ros/bags/output_file.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  std::string model;
  BagArguments bags;
  std::string csv;
  int reference = 50;
  core::ChangeOptions change;
};

void PrintResult(const core::RunMonitor& monitor, const Arguments& arguments) {
  const std::string episodes = Count(static_cast<std::size_t>(monitor.count()), "episode");
  if (!monitor.LogEvidence()) {
    std::printf("%s: too few to find a change, since the first %d are the reference (--reference)\n", episodes.c_str(),
                arguments.reference);
    return;
  }
  if (!monitor.change()) {
    std::printf("%s: no change\n", episodes.c_str());
    return;
  }
  const core::RunChange& change = *monitor.change();
  std::printf("%s: since some episode near %s (number %lld, %s) %s\n", episodes.c_str(), change.episode.c_str(),
              static_cast<long long>(change.index + 1), DateText(change.start).c_str(), change.text.c_str());
}

void FindDrift(const Arguments& arguments) {
  Options options = ReadOptions(arguments.bags);
  std::vector<std::string> read = FilesRead(arguments.bags);
  read.push_back(arguments.model);
  if (!arguments.csv.empty()) CheckTextOutput("--csv", arguments.csv, read);
  const core::Classifier classifier(LoadModel(arguments.model));
  FollowPreparation(classifier.model(), arguments.bags, &options);
  std::vector<core::Episode> episodes = ReadBags(arguments.bags, options.reader);
  std::stable_sort(episodes.begin(), episodes.end(),
                   [](const core::Episode& first, const core::Episode& second) { return first.start < second.start; });
  const std::vector<core::Classification> results = ClassifyAll(classifier, episodes, options.trainer.threads);

  std::optional<TextOutput> csv;
  if (!arguments.csv.empty()) {
    csv.emplace(arguments.csv);
    *csv->stream() << "episode_id,start,event,log_evidence,change\n";
  }
  core::RunMonitor monitor(arguments.reference, arguments.change);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const core::Episode& episode = episodes[index];
    const core::Diagnosis& diagnosis = results[index].diagnosis;
    monitor.Append(episode, diagnosis, classifier.model());
    if (!csv) continue;
    const std::optional<double> evidence = monitor.LogEvidence();
    *csv->stream() << CsvField(episode.id) << ',' << Number(core::ToSeconds(episode.start), 3) << ','
                   << CsvField(diagnosis.event) << ',' << (evidence ? Number(*evidence, 3) : "") << ','
                   << (monitor.change() ? 1 : 0) << '\n';
  }
  if (csv) csv->Finish();
  PrintResult(monitor, arguments);
}

}  // namespace

Command DriftCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "drift";
  command.description = "Tells whether forces, durations or the rates of events changed over recorded episodes";
  command.usage = "MODEL.bag BAG...";
  const auto arguments = std::make_shared<Arguments>();
  command.places.add_options()("model", po::value(&arguments->model)->required());
  command.positional.add("model", 1);
  AddBagArguments(&command, &arguments->bags);
  command.options.add_options()(
      "reference", po::value(&arguments->reference)->default_value(50)->notifier(InRange("--reference", 10, 100'000)),
      "The first episodes, which later ones are compared with");
  command.options.add_options()(
      "false-alarm-probability",
      po::value(&arguments->change.false_alarm_probability)->default_value(0.05)->notifier([](double probability) {
        if (!(probability > 0.0 && probability < 1.0)) throw UsageError("--false-alarm-probability must be in (0, 1)");
      }),
      "Of ever telling a change where there is none, however many the episodes");
  command.options.add_options()("csv", po::value(&arguments->csv),
                                "Table to write: episode_id,start,event,log_evidence,change; above 0 tells a change");
  command.run = [arguments] {
    FindDrift(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
