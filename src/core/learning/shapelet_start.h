#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// Where the learning starts: K-means centroids of the windows (section III.A of the paper).

namespace contact_shapelets::core {

/// Returns `count` shapelets of `length` samples [K, M]: K-means centroids of the z-normalised windows of `series`.
///
/// `series` are z-normalised. A series shorter than `length` is extended by its last value. Windows begin at every
/// max(1, M / 8)-th sample. Up to `most_windows` of them are drawn at random, without flat ones (standard deviation of
/// `flat_fraction` or less). Returns a matrix without rows if there are fewer than 2K such windows.
Eigen::MatrixXf StartShapelets(const std::vector<Eigen::VectorXf>& series, int length, int count, double flat_fraction,
                               int most_windows, std::uint64_t seed);

}  // namespace contact_shapelets::core
