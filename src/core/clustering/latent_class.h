#pragma once

#include <Eigen/Core>
#include <vector>

/// \file
/// Decides between votes by the model that they come from hidden classes.

namespace contact_shapelets::core {

/// The most probable class [N] of each series, 0 to `classes` - 1, by a latent class model of `votes`: series of one
/// class fall into a voter's parts with probabilities that are the voter's own, and independently of other voters
/// (Lazarsfeld and Henry 1968; of clusterings: Topchy, Jain and Punch, "A mixture model for clustering ensembles",
/// 2004).
///
/// Expectation maximisation from the labels `start` [N], each 0 to `classes` - 1. A voter whose parts have little to do
/// with the classes comes to count little, and classes may differ in size, neither of which K-means on the votes knows.
/// Each of `votes` [N] holds the part, from 0, of each series. Where a class would be left without a series, `start` is
/// returned. \throws std::invalid_argument where there is no vote, sizes differ, or a label or part is out of range.
Eigen::VectorXi LatentClasses(const std::vector<Eigen::VectorXi>& votes, const Eigen::Ref<const Eigen::VectorXi>& start,
                              int classes);

}  // namespace contact_shapelets::core
