#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/learning/learner.h"
#include "core/learning/series_distances.h"
#include "core/matching/ncc_kernel.h"
#include "core/matching/ncc_low_blocks.h"
#include "core/numerics/random.h"

namespace contact_shapelets::core {

/// Learns the shapelets of one bank: stochastic gradient steps of Adam on the objective of the paper (equation 6).
///
/// Each step is a sum over a batch of series: their best matches, then an exchange of the N x K distances, then each
/// shapelet's own gradient. Batches are what keeps memory and time from growing with the square of the number of
/// series.
class BankLearner {
 public:
  /// `series` are z-normalised, `distances` are theirs, for their similarity G; both outlive the learner. `start` is
  /// [K, M].
  BankLearner(const std::vector<Eigen::VectorXf>& series, const SeriesDistances& distances,
              const Eigen::Ref<const Eigen::MatrixXf>& start, const LearnerOptions& options, std::uint64_t seed,
              int threads);

  /// One step on a random batch. Returns the objective before the step.
  double Step();

  /// The objective and its gradient by the raw shapelets [K, M], for the given series (indices), without the L1 term,
  /// which is handled by its proximal step.
  double Evaluate(const std::vector<int>& chosen, Eigen::MatrixXd* gradient);

  /// The raw shapelets [K, M]; zeros at their ends are what the L1 term cut.
  Eigen::MatrixXf shapelets() const { return shapelets_.cast<float>(); }
  /// Replaces the raw shapelets [K, M].
  void set_shapelets(const Eigen::Ref<const Eigen::MatrixXd>& shapelets) { shapelets_ = shapelets; }
  /// The objective at the last step.
  double objective() const { return objective_; }

 private:
  void FindMatches(const std::vector<int>& chosen);
  Eigen::MatrixXd BatchWeights(const std::vector<int>& chosen) const;
  Eigen::MatrixXd ShapeletGradient(const std::vector<int>& chosen,
                                   const Eigen::Ref<const Eigen::MatrixXd>& distance_gradient) const;
  void AdamStep(const Eigen::Ref<const Eigen::MatrixXd>& gradient);

  const std::vector<Eigen::VectorXf>& series_;
  const SeriesDistances& distances_;
  LearnerOptions options_;
  int threads_;
  Random random_;
  Eigen::MatrixXd shapelets_;
  Eigen::MatrixXd first_moment_;
  Eigen::MatrixXd second_moment_;
  int step_ = 0;
  double objective_ = 0.0;
  std::vector<std::unique_ptr<WindowSet>> windows_;  ///< of each series, made when first needed
  std::vector<std::vector<Match>> matches_;          ///< of each series at the last step that it took part in
  std::vector<LowBlocks> low_blocks_;                ///< of each series, of its steps so far
  ShapeletHistory history_;                          ///< of the shapelets at these
};

}  // namespace contact_shapelets::core
