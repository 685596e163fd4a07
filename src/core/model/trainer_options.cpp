#include <sstream>

#include "contact_shapelets/core/trainer.h"

namespace contact_shapelets::core {

std::string TrainerOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool well, const char* name, const char* range, double value) {
    if (!well) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(clusters >= 2, "clusters", "at least 2", clusters);
  require(kmeans_restarts >= 1, "kmeans_restarts", "at least 1", kmeans_restarts);
  require(novelty_quantile > 0.0 && novelty_quantile <= 1.0, "novelty_quantile", "in (0, 1]", novelty_quantile);
  require(novelty_margin >= 1.0, "novelty_margin", "at least 1", novelty_margin);
  require(voters >= 0, "voters", "at least 0", voters);
  require(random_shapelets >= 0, "random_shapelets", "at least 0", random_shapelets);
  require(voting_episodes >= clusters, "voting_episodes", "at least the number of clusters", voting_episodes);
  require(threads >= 0, "threads", "at least 0", threads);
  return faults.str() + learner.Faults();
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
