#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

/// \file
/// Clusters by vote. The result of one K-means depends on its start and on the weights of its features. Many K-means
/// that each see other features of the same series agree on the differences that are real.

namespace contact_shapelets::core {

/// Features of N series that a group of voters looks at.
struct View {
  Eigen::MatrixXf features;        ///< [N, K], one series per row
  Eigen::VectorXf scales;          ///< [K], above 0: a voter with exponent p weighs column k by scales_k^-p
  int voters = 0;                  ///< number of voters that see these features, at least 0
  double greatest_exponent = 1.0;  ///< each voter draws p uniformly from 0 to this, at least 0
};

/// Receives the part of the votes that are done, (0, 1], now and then, in the thread that called ConsensusLabels(). An
/// exception of it ends the vote.
using VotesCallback = std::function<void(double)>;

/// Parameters of ConsensusLabels().
struct ConsensusOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< starts of the K-means that the decision begins with, at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal labels
};

/// Returns the labels [N] that the voters agree on.
///
/// Each voter sees a random half of its view's columns. It weighs them by a random exponent, so that short shapelets
/// count more with some voters than with others. Then it splits the series into C parts by one start of K-means.
/// K-means on the parts of all voters, one-hot and side by side, gives the start of LatentClasses(), which decides
/// (cluster ensembles: Strehl and Ghosh 2002; of random subspaces: Fred and Jain 2005). If a view says little about the
/// series, its voters disagree with one another, and their votes count little. `threads` is 1 or more; the result does
/// not depend on it.
///
/// \throws std::invalid_argument if no view has a voter, the views' sizes do not match, a greatest exponent is below 0,
///   a value is not finite, or N < C.
Eigen::VectorXi ConsensusLabels(const std::vector<View>& views, const ConsensusOptions& options, int threads,
                                const VotesCallback& on_votes = nullptr);

}  // namespace contact_shapelets::core
