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

/// Learns the shapelets of one bank by stochastic gradient steps of Adam on the objective of the paper (equation 6).
///
/// Each step takes a random batch of series. It finds their best matches, computes the objective from the distances,
/// and then the gradient of each shapelet. Because of batches, memory and time do not grow with the square of the
/// number of series.
class BankLearner {
 public:
  /// Starts with the shapelets `start` [K, M]. `series` are z-normalised, and `distances` are theirs, for their
  /// similarity G. Both must outlive the learner.
  BankLearner(const std::vector<Eigen::VectorXf>& series, const SeriesDistances& distances,
              const Eigen::Ref<const Eigen::MatrixXf>& start, const LearnerOptions& options, std::uint64_t seed,
              int threads);

  /// One step on a random batch. Returns the objective before the step.
  double Step();

  /// Returns the objective for the `chosen` series (indices), and its gradient by the raw shapelets [K, M]. Both are
  /// without the L1 term, which has a proximal step of its own.
  double Evaluate(const std::vector<int>& chosen, Eigen::MatrixXd* gradient);

  /// The raw shapelets [K, M]. The L1 term may have set values at their ends to zero.
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
  std::vector<std::unique_ptr<WindowSet>> windows_;  ///< by series, made when first needed
  std::vector<std::vector<Match>> matches_;          ///< by series, from the last step that it took part in
  std::vector<LowBlocks> low_blocks_;                ///< by series, from the steps so far
  ShapeletHistory history_;                          ///< the shapelets of the last steps
};

}  // namespace contact_shapelets::core
