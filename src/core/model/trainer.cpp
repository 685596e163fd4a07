#include "contact_shapelets/core/trainer.h"

#include <utility>

#include "core/model/training.h"

namespace contact_shapelets::core {

TrainingResult TrainModel(const std::vector<Episode>& episodes, const TrainerOptions& options,
                          const ProgressCallback& progress) {
  Training training = Train(episodes, options, progress);
  return {std::move(training.model), std::move(training.labels)};
}

}  // namespace contact_shapelets::core
