#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// \file
/// Where the learning starts: K-means centroids of the windows (section III.A of the paper).

namespace contact_shapelets::core {

/// K shapelets [K, M]: K-means centroids of the z-normalised windows of `series`.
///
/// `series` are z-normalised; one shorter than `length` is extended by its last value. Windows are taken at a stride of
/// max(1, M / 8); flat ones (standard deviation under `flat_fraction`, the series having one of 1) are left out; at the
/// most `most_windows` are drawn at random. Returns a matrix without rows where fewer than 2K windows are left.
Eigen::MatrixXf StartShapelets(const std::vector<Eigen::VectorXf>& series, int length, int count, double flat_fraction,
                               int most_windows, std::uint64_t seed);

}  // namespace contact_shapelets::core
