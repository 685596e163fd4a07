#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact_shapelets/core/kmeans.h"

/// \file
/// Clusters by vote. K-means on one set of features answers to how those happen to be weighted; several clusterings of
/// the same series, each seeing the shapelets with other weights, agree where the series really differ.

namespace contact_shapelets::core {

/// Features of the same N series as one voter sees them: [N, K], one series per row.
using View = Eigen::MatrixXf;

/// One view of `features` [N, K] for each exponent p: column k times scale_k^-p, so that short shapelets count the more
/// the larger p is. `scales` [K] are above 0.
std::vector<View> ScaleViews(const Eigen::Ref<const Eigen::MatrixXf>& features,
                             const Eigen::Ref<const Eigen::VectorXf>& scales, const std::vector<double>& exponents);

/// The labels [N] that the views agree on: K-means of each view; a series becomes the one-hot labels that it got, side
/// by side, and K-means on those decides (cluster ensembles: Strehl and Ghosh 2002; by K-means: Topchy, Jain and Punch
/// 2003). A single view decides alone. `threads` is 1 or more; the result does not depend on it. \throws
/// std::invalid_argument where there is no view, their numbers of rows differ, or KMeans() would throw.
Eigen::VectorXi ConsensusLabels(const std::vector<View>& views, const KMeansOptions& options, int threads);

}  // namespace contact_shapelets::core
