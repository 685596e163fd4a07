#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "contact_shapelets/core/trainer.h"
#include "core/numerics/interval.h"

namespace contact_shapelets::core {

std::string TrainerOptions::Faults() const {
  std::ostringstream faults;
  const auto check = [&faults](const char* name, double value, const Interval& interval) {
    CheckRange(name, value, interval, &faults);
  };
  check("clusters", clusters, {2, kMostClusters});
  check("kmeans_restarts", kmeans_restarts, {1, 1000});
  check("novelty_quantile", novelty_quantile, {0, 1, true});
  check("novelty_margin", novelty_margin, {1, 1000});
  check("voters", voters, {0, 2000});
  check("random_shapelets", random_shapelets, {0, 10000});
  check("voting_episodes", voting_episodes, {static_cast<double>(clusters), 50000});
  check("threads", threads, {0, 1024});
  return faults.str() + learner.Faults();
}

int TakeIncomplete(const TrainerOptions& options, std::vector<Episode>* episodes) {
  if (options.incomplete) return 0;
  const auto kept = std::stable_partition(episodes->begin(), episodes->end(),
                                          [](const Episode& episode) { return episode.complete; });
  const auto taken = static_cast<int>(episodes->end() - kept);
  episodes->erase(kept, episodes->end());
  if (taken > 0 && static_cast<int>(episodes->size()) < options.clusters) {
    throw std::invalid_argument("expected at least " + std::to_string(options.clusters) +
                                " complete episodes, but found " + std::to_string(episodes->size()) + " beside " +
                                std::to_string(taken) +
                                " incomplete ones (`inspect` shows why; use --incomplete or the parameter incomplete "
                                "to train on them too)");
  }
  return taken;
}

TrainerOptions PaperOptions() {
  TrainerOptions options;
  options.voters = 0;
  options.log_distances = false;
  options.learner.objective = Objective::kPaper;
  options.learner.scales = {0.4};
  options.learner.flat_fraction = 0.0;
  options.learner.diversity = 0.01;
  options.learner.sparsity = 0.1;
  options.learner.steps = 40;
  return options;
}

}  // namespace contact_shapelets::core
