/// How often a RunMonitor tells a change of an unchanged run, and after how many episodes it tells a real one. Runs
/// draw their episodes, with replacement, from two bags: one before and one after the change.

#include <boost/program_options.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "contact_shapelets/ros/episode_bag_reader.h"
#include "contact_shapelets/ros/model_bag.h"
#include "core/drift/run_monitor.h"
#include "core/numerics/parallel.h"
#include "core/numerics/random.h"

namespace contact_shapelets {
namespace {

constexpr int kReference = 50;

struct Arguments {
  std::string model;
  std::string unchanged;
  std::string changed;
  float force = 1.0F;
  int runs = 1000;
  int episodes = 2000;
  int before = 200;
  int changed_runs = 200;
};

/// Episodes with their diagnoses, to draw from.
class Pool {
 public:
  Pool(const core::Classifier& classifier, const std::string& bag, float force)
      : model_(&classifier.model()), episodes_(ReadEpisodes(bag, BagReaderOptions()).episodes) {
    for (core::Episode& episode : episodes_) episode.force *= force;
    for (const core::Episode& episode : episodes_) diagnoses_.push_back(classifier.Classify(episode).diagnosis);
  }

  void AppendOne(core::Random* random, core::RunMonitor* monitor) const {
    const auto index = static_cast<std::size_t>(random->Index(static_cast<int>(episodes_.size())));
    monitor->Append(episodes_[index], diagnoses_[index], *model_);
  }

 private:
  const core::Model* model_;
  std::vector<core::Episode> episodes_;
  std::vector<core::Diagnosis> diagnoses_;
};

core::RunMonitor MonitorOf(int run) {
  core::ChangeOptions options;
  options.seed = static_cast<std::uint64_t>(run) + 1;
  return {kReference, options};
}

void StudyUnchangedRuns(const Arguments& arguments, const Pool& pool) {
  std::vector<int> alarms(static_cast<std::size_t>(arguments.runs));
  core::ParallelFor(arguments.runs, core::ThreadCount(0), [&](int run) {
    core::Random random(core::StreamSeed(1, static_cast<std::uint32_t>(run)));
    core::RunMonitor monitor = MonitorOf(run);
    for (int episode = 0; episode < arguments.episodes && !monitor.change(); ++episode)
      pool.AppendOne(&random, &monitor);
    alarms[static_cast<std::size_t>(run)] = monitor.change() ? 1 : 0;
  });
  int sum = 0;
  for (const int alarm : alarms) sum += alarm;
  std::printf("unchanged: %d of %d runs of %d episodes told a change\n", sum, arguments.runs, arguments.episodes);
}

void StudyChangedRuns(const Arguments& arguments, const Pool& unchanged, const Pool& changed) {
  std::map<std::string, int> texts;
  std::vector<double> delays;
  std::vector<double> errors;
  int early = 0;
  for (int run = 0; run < arguments.changed_runs; ++run) {
    core::Random random(core::StreamSeed(2, static_cast<std::uint32_t>(run)));
    core::RunMonitor monitor = MonitorOf(run);
    for (int episode = 0; episode < arguments.before; ++episode) unchanged.AppendOne(&random, &monitor);
    early += monitor.change() ? 1 : 0;
    if (monitor.change()) continue;
    int delay = 0;
    for (; delay < arguments.episodes && !monitor.change(); ++delay) changed.AppendOne(&random, &monitor);
    delays.push_back(delay);
    if (!monitor.change()) continue;
    errors.push_back(std::abs(static_cast<double>(monitor.change()->index - arguments.before)));
    const std::string& text = monitor.change()->text;
    ++texts[text.substr(0, text.find(" by "))];
  }
  double mean = 0.0;
  double error = 0.0;
  for (const double delay : delays) mean += delay / static_cast<double>(delays.size());
  for (const double value : errors) error += value / static_cast<double>(errors.size());
  std::printf(
      "changed after %d episodes: told after %.1f episodes on average (%d of %d runs told it before),\n"
      "the start is wrong by %.1f episodes on average\n",
      arguments.before, mean, early, arguments.changed_runs, error);
  for (const auto& [text, count] : texts) std::printf("  %4d  %s\n", count, text.c_str());
}

void Study(const Arguments& arguments) {
  const core::Classifier classifier(LoadModel(arguments.model));
  const Pool unchanged(classifier, arguments.unchanged, 1.0F);
  const Pool changed(classifier, arguments.changed, arguments.force);
  StudyChangedRuns(arguments, unchanged, changed);
  std::fflush(stdout);
  StudyUnchangedRuns(arguments, unchanged);
}

}  // namespace
}  // namespace contact_shapelets

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  contact_shapelets::Arguments arguments;
  po::options_description options("How soon and how rightly a change over time is told");
  auto add = options.add_options();
  add("model", po::value(&arguments.model)->required(), "The model file");
  add("unchanged", po::value(&arguments.unchanged)->required(), "Bag of episodes before the change");
  add("changed", po::value(&arguments.changed)->required(), "Bag of episodes after it");
  add("force", po::value(&arguments.force)->default_value(1.0F), "Factor on the forces after the change");
  add("runs", po::value(&arguments.runs)->default_value(arguments.runs), "Runs without a change");
  add("episodes", po::value(&arguments.episodes)->default_value(arguments.episodes), "Episodes of each");
  add("before", po::value(&arguments.before)->default_value(arguments.before), "Episodes before a change");
  add("changed-runs", po::value(&arguments.changed_runs)->default_value(arguments.changed_runs), "Runs with a change");
  try {
    po::variables_map values;
    po::store(po::parse_command_line(argc, argv, options), values);
    po::notify(values);
    contact_shapelets::Study(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "change_study: %s\n", error.what());
    return 1;
  }
  return 0;
}
