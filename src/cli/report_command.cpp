#include "cli/report_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "cli/common.h"
#include "cli/episode_table.h"
#include "cli/event_scores.h"
#include "cli/report_page.h"
#include "cli/text.h"
#include "cli/text_output.h"
#include "contact_shapelets/ros/model_bag.h"
#include "core/numerics/series.h"
#include "ros/bags/output_file.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string model;
  std::string folder;
};

std::vector<Eigen::VectorXf> SeriesOf(const std::vector<core::Episode>& episodes, double sample_period) {
  std::vector<Eigen::VectorXf> series;
  for (const core::Episode& episode : episodes) {
    const auto length = static_cast<int>(std::lround(episode.duration() / sample_period));
    series.push_back(core::StretchedTo(episode.force, std::max(2, length)));
  }
  return series;
}

void CreateFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error("--out " + folder + ": expected a folder, but it cannot be made: " + error.message());
  }
}

/// Without --model, the first file is the model.
void TakeModel(Arguments* arguments) {
  if (!arguments->model.empty()) return;
  std::vector<std::string>& bags = arguments->bags.bags;
  if (bags.size() < 2) throw UsageError("report: expected MODEL.bag BAG... --out DIR, but bags is missing");
  arguments->model = bags.front();
  bags.erase(bags.begin());
}

/// \throws std::runtime_error if `path` is a file that does not begin as a report's file does.
void CheckIsReports(const std::string& path, const std::string& start) {
  std::ifstream file(path);
  std::string found(start.size(), '\0');
  file.read(&found[0], static_cast<std::streamsize>(found.size()));
  const auto count = static_cast<std::size_t>(file.gcount());
  if (count > 0 && found != start) {
    throw std::runtime_error("--out: " + path + " is not of a report, and is not replaced; choose another folder");
  }
}

void Report(const Arguments& arguments) {
  Options options = ReadOptions(arguments.bags);
  const core::Classifier classifier(LoadModel(arguments.model));
  ReportContents contents;
  contents.model = classifier.model();
  contents.model_file = arguments.model;
  contents.bags = arguments.bags.bags;
  FollowPreparation(contents.model, arguments.bags, &options);
  CreateFolder(arguments.folder);
  const std::string page_path = (std::filesystem::path(arguments.folder) / "index.html").string();
  const std::string table_path = (std::filesystem::path(arguments.folder) / "episodes.csv").string();
  std::vector<std::string> read = FilesRead(arguments.bags);
  read.push_back(arguments.model);
  for (const std::string& path : {page_path, table_path}) CheckTextOutput("--out", path, read);
  CheckIsReports(page_path, kPageStart);
  CheckIsReports(table_path, kTableStart);
  contents.episodes = ReadBags(arguments.bags, options.reader);
  contents.results = ClassifyAll(classifier, contents.episodes, options.trainer.threads);
  contents.series = SeriesOf(contents.episodes, contents.model.sample_period);

  TextOutput table(table_path);
  TextOutput page(page_path);
  WriteCsv(contents.episodes, contents.results, table.stream());
  *page.stream() << ReportPage(contents);
  // Page and table belong together: if one cannot be written, the other is not replaced.
  table.Check();
  page.Check();
  table.Finish();
  page.Finish();
  std::printf("wrote %s to %s and %s\n", Count(contents.episodes.size(), "episode").c_str(), page_path.c_str(),
              table_path.c_str());
  PrintFarEpisodes(contents.model, contents.episodes);
  EventScores(contents.model, contents.episodes, NamedEpisodes(contents.results)).Print();
}

}  // namespace

Command ReportCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "report";
  command.description = "Writes a page with a model's diagnoses of bags";
  command.usage = "MODEL.bag BAG... --out DIR, or BAG... --model MODEL.bag --out DIR";
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(&command, &arguments->bags);
  AddLabelsOption(&command, &arguments->bags);
  command.options.add_options()("out", po::value(&arguments->folder)->required(),
                                "The folder to write index.html and episodes.csv to");
  command.options.add_options()("model", po::value(&arguments->model), "The model file (default: the first file)");
  command.run = [arguments] {
    TakeModel(arguments.get());
    Report(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
