#include "cli/evaluate_command.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "cli/common.h"
#include "cli/evaluation_report.h"
#include "cli/text.h"
#include "cli/text_output.h"
#include "core/numerics/parallel.h"
#include "evaluation/methods.h"
#include "evaluation/protocol.h"
#include "evaluation/ucr_reader.h"
#include "ros/bags/output_file.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  std::string data;
  std::vector<std::string> data_sets{"all"};
  std::vector<std::string> methods = evaluation::ClustererNames();
  BagArguments bags;
  std::vector<std::string> test_bags;
  std::string bags_name;
  int seeds = 5;
  int jobs = 0;
  std::string json;
};

/// Prints each fault at once, because a run may be long.
class Faults {
 public:
  void Add(const std::string& fault) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::cerr << "shapelets: " << fault << '\n';
    any_ = true;
  }
  bool any() const { return any_; }

 private:
  std::mutex mutex_;
  bool any_ = false;
};

/// Returns the episodes that have an outcome. `numbers` holds the class of each outcome.
evaluation::LabelledSeries ReadLabelledBags(const std::vector<std::string>& paths, const BagReaderOptions& options,
                                            std::map<std::string, int>* numbers) {
  evaluation::LabelledSeries labelled;
  std::vector<int> classes;
  for (const core::Episode& episode : ReadAllEpisodes(paths, options)) {
    if (episode.outcome.empty()) continue;
    labelled.series.push_back(episode.force);
    classes.push_back(numbers->emplace(episode.outcome, static_cast<int>(numbers->size())).first->second);
  }
  if (classes.empty()) {
    throw std::runtime_error(Joined(paths, ", ") + ": expected episodes with an outcome, found none");
  }
  labelled.classes = Eigen::Map<Eigen::VectorXi>(classes.data(), static_cast<Eigen::Index>(classes.size()));
  return labelled;
}

evaluation::DataSet ReadBagDataSet(const Arguments& arguments, const BagReaderOptions& options) {
  std::map<std::string, int> numbers;
  const std::vector<std::string>& paths = arguments.bags.bags;
  const std::string name =
      arguments.bags_name.empty() ? std::filesystem::path(paths.front()).stem().string() : arguments.bags_name;
  evaluation::DataSet data_set;
  data_set.name = name;
  data_set.train = ReadLabelledBags(paths, options, &numbers);
  if (arguments.test_bags.empty()) {
    data_set = evaluation::SplitByClass(name, data_set.train, static_cast<int>(numbers.size()), 0.5, 0);
  } else {
    data_set.test = ReadLabelledBags(arguments.test_bags, options, &numbers);
  }
  data_set.class_count = static_cast<int>(numbers.size());
  const auto fewest = static_cast<int>(std::min(data_set.train.series.size(), data_set.test.series.size()));
  if (data_set.class_count < 2 || fewest < data_set.class_count) {
    throw std::runtime_error(Joined(paths, ", ") +
                             ": expected 2 or more outcomes and an episode for each in both splits, found " +
                             std::to_string(data_set.class_count) + " outcomes and " + std::to_string(fewest) +
                             " episodes in the smaller split");
  }
  return data_set;
}

std::vector<evaluation::DataSet> ReadDataSets(const Arguments& arguments, const BagReaderOptions& options,
                                              Faults* faults) {
  std::vector<evaluation::DataSet> data_sets;
  const auto attempt = [&](const std::function<evaluation::DataSet()>& read) {
    try {
      data_sets.push_back(read());
    } catch (const std::exception& error) {
      faults->Add(error.what());
    }
  };
  if (!arguments.data.empty()) {
    const bool all = arguments.data_sets == std::vector<std::string>{"all"};
    for (const std::string& name : all ? evaluation::UcrDataSetNames(arguments.data) : arguments.data_sets) {
      std::vector<std::string> notes;
      attempt([&] { return evaluation::ReadUcrDataSet(arguments.data, name, &notes); });
      for (const std::string& note : notes) std::cerr << "note: " << note << '\n';
    }
  }
  if (!arguments.bags.bags.empty()) attempt([&] { return ReadBagDataSet(arguments, options); });
  return data_sets;
}

/// One data set, method and seed: the unit of parallel work.
struct Task {
  const evaluation::DataSet* data_set;
  std::string method;
  std::uint64_t seed;
  double size;  ///< number of samples, for the progress and for starting long tasks first
};

std::vector<Task> MakeTasks(const Arguments& arguments, const std::vector<evaluation::DataSet>& data_sets) {
  std::vector<Task> tasks;
  for (const evaluation::DataSet& data_set : data_sets) {
    double size = 0.0;
    for (const evaluation::LabelledSeries* split : {&data_set.train, &data_set.test}) {
      for (const Eigen::VectorXf& series : split->series) size += static_cast<double>(series.size());
    }
    for (const std::string& method : arguments.methods) {
      for (int seed = 0; seed < arguments.seeds; ++seed) {
        tasks.push_back({&data_set, method, static_cast<std::uint64_t>(seed), size});
      }
    }
  }
  return tasks;
}

/// Returns the results in the order of `tasks`, without those that failed.
std::vector<evaluation::EvaluationResult> RunTasks(const std::vector<Task>& tasks, const core::TrainerOptions& trainer,
                                                   int jobs, Faults* faults) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tasks[a].size > tasks[b].size; });
  const double total =
      std::accumulate(tasks.begin(), tasks.end(), 0.0, [](double sum, const Task& task) { return sum + task.size; });
  std::vector<std::optional<evaluation::EvaluationResult>> outcomes(tasks.size());
  ProgressLine line("evaluating");
  std::mutex line_mutex;
  double done = 0.0;
  core::ParallelFor(static_cast<int>(tasks.size()), jobs, [&](int place) {
    const std::size_t index = order[static_cast<std::size_t>(place)];
    const Task& task = tasks[index];
    try {
      const std::unique_ptr<evaluation::Clusterer> clusterer = evaluation::MakeClusterer(task.method, trainer);
      outcomes[index] = evaluation::Evaluate(*task.data_set, task.method, task.seed, clusterer.get());
    } catch (const std::exception& error) {
      faults->Add(task.data_set->name + ", " + task.method + ", seed " + std::to_string(task.seed) + ": " +
                  error.what());
    }
    const std::lock_guard<std::mutex> lock(line_mutex);
    done += task.size;
    line.Show(done / total);
  });
  std::vector<evaluation::EvaluationResult> results;
  for (const std::optional<evaluation::EvaluationResult>& outcome : outcomes) {
    if (outcome) results.push_back(*outcome);
  }
  return results;
}

/// Returns `names`. \throws UsageError if a name is not that of a method.
std::vector<std::string> CheckedMethods(const std::vector<std::string>& names) {
  const core::TrainerOptions defaults;
  for (const std::string& name : names) {
    try {
      evaluation::MakeClusterer(name, defaults);
    } catch (const std::invalid_argument& error) {
      throw UsageError(std::string("--methods: ") + error.what());
    }
  }
  return names;
}

std::vector<std::string> FilesRead(const Arguments& arguments) {
  std::vector<std::string> files = FilesRead(arguments.bags);
  files.insert(files.end(), arguments.test_bags.begin(), arguments.test_bags.end());
  return files;
}

/// Returns the exit status: 1 if faults left out results.
int RunEvaluation(const Arguments& arguments) {
  if (arguments.data.empty() && arguments.bags.bags.empty()) {
    throw UsageError("evaluate: expected --data or --bags, found neither");
  }
  const Options options = ReadOptions(arguments.bags);
  if (!arguments.json.empty()) CheckTextOutput("--json", arguments.json, FilesRead(arguments));
  Faults faults;
  const std::vector<evaluation::DataSet> data_sets = ReadDataSets(arguments, options.reader, &faults);
  const std::vector<Task> tasks = MakeTasks(arguments, data_sets);
  const std::vector<evaluation::EvaluationResult> results =
      RunTasks(tasks, options.trainer, core::ThreadCount(arguments.jobs), &faults);
  std::vector<std::string> names;
  for (const evaluation::DataSet& data_set : data_sets) names.push_back(data_set.name);
  if (!names.empty()) WriteMarkdown(results, names, arguments.methods, &std::cout);
  if (!arguments.json.empty()) {
    TextOutput json(arguments.json);
    WriteJson(results, json.stream());
    json.Finish();
  }
  return faults.any() ? 1 : 0;
}

}  // namespace

Command EvaluateCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "evaluate";
  command.description = "Compares methods on data sets with known classes";
  command.usage = "--data DIR --datasets A,B --methods M,N --seeds 5";
  const auto arguments = std::make_shared<Arguments>();
  auto add = command.options.add_options();
  add("data", po::value(&arguments->data), "A folder of the UCR archive: NAME/NAME_TRAIN.tsv, NAME/NAME_TEST.tsv");
  add("datasets", po::value<std::string>()->notifier([arguments](const std::string& names) {
    arguments->data_sets = SplitAtCommas("--datasets", names);
  }),
      "Names separated by commas, or all (default)");
  add("methods", po::value<std::string>()->notifier([arguments](const std::string& names) {
    arguments->methods = CheckedMethods(SplitAtCommas("--methods", names));
  }),
      "Names separated by commas (default: all)");
  add("bags", po::value(&arguments->bags.bags)->multitoken(),
      "Recorded bags as a data set, with their outcomes as classes");
  add("test-bags", po::value(&arguments->test_bags)->multitoken(),
      "Bags to test on (default: half of each outcome's episodes of --bags)");
  add("bags-name", po::value(&arguments->bags_name), "Name of the bags in the table (default: name of the first file)");
  AddReaderOptions(&command, &arguments->bags);
  add("seeds", po::value(&arguments->seeds)->notifier(InRange("--seeds", 1, 10000)),
      "Runs per data set and method, with the seeds 0, 1, ... (default 5)");
  add("jobs", po::value(&arguments->jobs)->notifier(InRange("--jobs", 0, 1024)),
      "Runs at the same time (default: one per core); results stay the same");
  add("json", po::value(&arguments->json), "Writes the scores of every run to this file too");
  command.run = [arguments] { return RunEvaluation(*arguments); };
  return command;
}

}  // namespace contact_shapelets::cli
