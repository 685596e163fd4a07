#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact_shapelets/core/trainer.h"
#include "evaluation/clusterer.h"

/// \file
/// NN-STNE as a method under evaluation.

namespace contact_shapelets::core {
struct Training;
}

namespace contact_shapelets::evaluation {

/// The trainer and classifier of this package. Features are the distances to the learned shapelets and, beside them, to
/// the random ones, which only vote.
class StneClusterer : public Clusterer {
 public:
  /// Trains with `options`. Fit() sets clusters and seed; training uses one thread.
  explicit StneClusterer(const core::TrainerOptions& options);
  ~StneClusterer() override;

  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;
  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;
  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;

 private:
  core::TrainerOptions options_;
  std::unique_ptr<core::Training> training_;
};

}  // namespace contact_shapelets::evaluation
