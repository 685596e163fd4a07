#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

/// \file
/// Clusters by vote. One K-means answers to how its features happen to be weighted and to where it started; many that
/// each see something else of the same series agree where the series really differ.

namespace contact_shapelets::core {

/// Features of N series that a group of voters looks at.
struct View {
  Eigen::MatrixXf features;        ///< [N, K], one series per row
  Eigen::VectorXf scales;          ///< [K], above 0: a voter with exponent p weighs column k by scales_k^-p
  int voters = 0;                  ///< how many look at it, at least 0
  double greatest_exponent = 1.0;  ///< p is uniform from 0 to this, at least 0
};

/// Called now and then from the thread that asked, with the part of the votes that are given, (0, 1]. What it throws
/// ends the vote.
using VotesCallback = std::function<void(double)>;

/// Parameters of ConsensusLabels().
struct ConsensusOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< of the K-means that the decision begins with, at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal labels
};

/// The labels [N] that the voters agree on.
///
/// A voter sees a random half of its view's columns, weighs them by a random exponent, so that short shapelets count
/// more with some voters than with others, and splits the series into C parts by one start of K-means. K-means on these
/// parts, one-hot and side by side, is where LatentClasses() starts from, which decides (cluster ensembles: Strehl and
/// Ghosh 2002; of random subspaces: Fred and Jain 2005). A voter that fits the series poorly splits them otherwise at
/// each start, so that its votes scatter and count little. `threads` is 1 or more; the result does not depend on it.
/// \throws std::invalid_argument where no view has a voter, the views' sizes do not match, a greatest exponent is below
///   0, a value is not finite, or N < C.
Eigen::VectorXi ConsensusLabels(const std::vector<View>& views, const ConsensusOptions& options, int threads,
                                const VotesCallback& on_votes = nullptr);

}  // namespace contact_shapelets::core
