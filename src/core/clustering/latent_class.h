#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// Decides on clusters from votes by a latent class model.

namespace contact_shapelets::core {

/// Returns the most probable class [N] of each series, 0 to `classes` - 1, by a latent class model of `votes`: each
/// voter puts the series of a class into its parts with its own probabilities, independently of other voters
/// (Lazarsfeld and Henry 1968; of clusterings: Topchy, Jain and Punch, "A mixture model for clustering ensembles",
/// 2004).
///
/// Each of `votes` [N] holds the part of each series, from 0. Expectation maximisation starts from the labels `start`
/// [N], each 0 to `classes` - 1. Unlike K-means on the votes, it gives a voter little weight if its parts have little
/// to do with the classes, and it allows classes of different sizes. If a class would be left without a series, returns
/// `start`. \throws std::invalid_argument if there is no vote, sizes differ, or a label or part is out of range.
Eigen::VectorXi LatentClasses(const std::vector<Eigen::VectorXi>& votes, const Eigen::Ref<const Eigen::VectorXi>& start,
                              int classes);

}  // namespace contact_shapelets::core
