#pragma once

#include <Eigen/Core>
#include <cstdint>

/// \file
/// K-means with k-means++ seeding. All methods without a clustering of their own use it.

namespace contact_shapelets::core {

/// Parameters of KMeans().
struct KMeansOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< k-means++ starts, at least 1; the result with the least inertia is kept
  int iterations = 300;    ///< greatest number of Lloyd's rounds per start, at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal results
};

/// A partition of N points into C clusters.
struct KMeansResult {
  Eigen::MatrixXf centroids;  ///< [C, D], one per row
  Eigen::VectorXi labels;     ///< [N], 0 to C - 1
  double inertia = 0.0;       ///< sum of squared distances to the assigned centroids
};

/// Clusters `points` [N, D], one per row, by Lloyd's algorithm from k-means++ starts (Arthur and Vassilvitskii 2007).
///
/// An empty cluster takes the point farthest from its centroid. Clusters are numbered in the order of their first
/// points, so that equal partitions have equal labels. \throws std::invalid_argument if N < C, an option is out of
/// range, or a value is not finite.
KMeansResult KMeans(const Eigen::Ref<const Eigen::MatrixXf>& points, const KMeansOptions& options);

/// Returns the row of `centroids` [C, D] nearest to `point` [D] in Euclidean distance; the lowest index of equal ones.
int NearestCentroid(const Eigen::Ref<const Eigen::MatrixXf>& centroids, const Eigen::Ref<const Eigen::VectorXf>& point);

/// Returns the nearest row of `centroids` [C, D] for each row of `points` [N, D].
Eigen::VectorXi NearestCentroids(const Eigen::Ref<const Eigen::MatrixXf>& centroids,
                                 const Eigen::Ref<const Eigen::MatrixXf>& points);

}  // namespace contact_shapelets::core
