#include "core/clustering/consensus.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/clustering/kmeans.h"
#include "core/clustering/latent_class.h"
#include "core/numerics/parallel.h"
#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

/// Returns the view of each voter.
std::vector<const View*> Voters(const std::vector<View>& views) {
  std::vector<const View*> voters;
  for (const View& view : views) {
    if (view.scales.size() != view.features.cols()) throw std::invalid_argument("a view needs a scale for each column");
    if (!(view.greatest_exponent >= 0.0)) throw std::invalid_argument("a view's greatest exponent is below 0");
    if (view.features.rows() != views.front().features.rows()) {
      throw std::invalid_argument("the views differ in their number of series");
    }
    voters.insert(voters.end(), static_cast<std::size_t>(std::max(0, view.voters)), &view);
  }
  if (voters.empty()) throw std::invalid_argument("a consensus needs at least one voter");
  return voters;
}

/// Returns the part [N] that one voter puts each series into.
Eigen::VectorXi Vote(const View& view, int clusters, std::uint64_t seed) {
  Random random(StreamSeed(seed, 0));
  const auto columns = static_cast<int>(view.features.cols());
  const double exponent = random.Uniform(0.0, view.greatest_exponent);
  std::vector<int> seen = random.Sample(columns, std::min(columns, std::max(2, columns / 2)));
  std::sort(seen.begin(), seen.end());
  Eigen::MatrixXf points(view.features.rows(), seen.size());
  for (std::size_t index = 0; index < seen.size(); ++index) {
    points.col(static_cast<Eigen::Index>(index)) =
        view.features.col(seen[index]) * std::pow(view.scales[seen[index]], static_cast<float>(-exponent));
  }
  KMeansOptions options;
  options.clusters = clusters;
  options.restarts = 1;
  options.seed = StreamSeed(seed, 1);
  return KMeans(points, options).labels;
}

/// Returns the one-hot parts of all votes side by side, [N, parts].
Eigen::MatrixXf Ballots(const std::vector<Eigen::VectorXi>& votes) {
  Eigen::Index parts = 0;
  for (const Eigen::VectorXi& vote : votes) parts += vote.maxCoeff() + 1;
  Eigen::MatrixXf ballots = Eigen::MatrixXf::Zero(votes.front().size(), parts);
  Eigen::Index first = 0;
  for (const Eigen::VectorXi& vote : votes) {
    for (Eigen::Index row = 0; row < vote.size(); ++row) ballots(row, first + vote[row]) = 1.0F;
    first += vote.maxCoeff() + 1;
  }
  return ballots;
}

}  // namespace

Eigen::VectorXi ConsensusLabels(const std::vector<View>& views, const ConsensusOptions& options, int threads,
                                const VotesCallback& on_votes) {
  const std::vector<const View*> voters = Voters(views);
  const auto count = static_cast<int>(voters.size());
  std::vector<Eigen::VectorXi> votes(voters.size());
  // A round keeps all threads busy, and is short enough to report progress after it.
  const int round = 4 * std::max(1, std::min(threads, count));
  for (int first = 0; first < count; first += round) {
    const int last = std::min(count, first + round);
    ParallelFor(last - first, threads, [&](int index) {
      const auto voter = static_cast<std::size_t>(first + index);
      votes[voter] =
          Vote(*voters[voter], options.clusters, StreamSeed(options.seed, static_cast<std::uint32_t>(voter)));
    });
    if (on_votes) on_votes(static_cast<double>(last) / count);
  }
  KMeansOptions start;
  start.clusters = options.clusters;
  start.restarts = options.restarts;
  start.seed = StreamSeed(options.seed, static_cast<std::uint32_t>(voters.size()));
  return LatentClasses(votes, KMeans(Ballots(votes), start).labels, options.clusters);
}

}  // namespace contact_shapelets::core
