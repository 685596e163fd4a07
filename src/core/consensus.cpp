#include "contact_shapelets/core/consensus.h"

#include <stdexcept>

#include "contact_shapelets/core/parallel.h"

namespace contact_shapelets::core {

std::vector<View> ScaleViews(const Eigen::Ref<const Eigen::MatrixXf>& features,
                             const Eigen::Ref<const Eigen::VectorXf>& scales, const std::vector<double>& exponents) {
  if (features.cols() != scales.size()) throw std::invalid_argument("there must be one scale for each feature");
  std::vector<View> views;
  for (const double exponent : exponents) {
    const Eigen::VectorXf weights = scales.array().pow(static_cast<float>(-exponent));
    views.emplace_back(features * weights.asDiagonal());
  }
  return views;
}

Eigen::VectorXi ConsensusLabels(const std::vector<View>& views, const KMeansOptions& options, int threads) {
  if (views.empty()) throw std::invalid_argument("a consensus needs at least one view");
  const Eigen::Index count = views.front().rows();
  for (const View& view : views) {
    if (view.rows() != count) throw std::invalid_argument("the views differ in their number of series");
  }
  std::vector<Eigen::VectorXi> votes(views.size());
  ParallelFor(static_cast<int>(views.size()), threads, [&](int index) {
    KMeansOptions voter = options;
    voter.seed = options.seed * 31U + static_cast<std::uint64_t>(index);
    votes[static_cast<std::size_t>(index)] = KMeans(views[static_cast<std::size_t>(index)], voter).labels;
  });
  if (votes.size() == 1) return votes.front();

  Eigen::MatrixXf ballots = Eigen::MatrixXf::Zero(count, static_cast<Eigen::Index>(votes.size()) * options.clusters);
  for (std::size_t voter = 0; voter < votes.size(); ++voter) {
    for (Eigen::Index row = 0; row < count; ++row) {
      ballots(row, static_cast<Eigen::Index>(voter) * options.clusters + votes[voter][row]) = 1.0F;
    }
  }
  return KMeans(ballots, options).labels;
}

}  // namespace contact_shapelets::core
