#pragma once

#include <Eigen/Core>
#include <cstdint>

/// \file
/// K-means with k-means++ seeding: the one clustering of every method that has none of its own, so that these
/// differ in features alone.

namespace contact_shapelets::core {

/// Parameters of KMeans().
struct KMeansOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< independent k-means++ starts, the one of least inertia is kept; at least 1
  int iterations = 300;    ///< Lloyd rounds per start at the most; at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal results, whatever the machine's number of threads
};

/// A partition of N points into C clusters.
struct KMeansResult {
  Eigen::MatrixXf centroids;  ///< [C, D], one per row
  Eigen::VectorXi labels;     ///< [N], 0 to C - 1
  double inertia = 0.0;       ///< sum of squared distances to the assigned centroids
};

/// Clusters `points` [N, D], one per row, by Lloyd's algorithm from k-means++ starts (Arthur and Vassilvitskii 2007).
///
/// A cluster that empties is refilled with the point farthest from its centroid. Clusters are numbered by the first
/// point that they hold, so that equal partitions have equal labels.
/// \throws std::invalid_argument where N < C, an option is out of range, or a value is not finite.
KMeansResult KMeans(const Eigen::Ref<const Eigen::MatrixXf>& points, const KMeansOptions& options);

/// Index of the row of `centroids` [C, D] nearest to `point` [D] in Euclidean distance; the lower one of a tie.
int NearestCentroid(const Eigen::Ref<const Eigen::MatrixXf>& centroids, const Eigen::Ref<const Eigen::VectorXf>& point);

/// NearestCentroid() of each row of `points` [N, D].
Eigen::VectorXi NearestCentroids(const Eigen::Ref<const Eigen::MatrixXf>& centroids,
                                 const Eigen::Ref<const Eigen::MatrixXf>& points);

}  // namespace contact_shapelets::core
