#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// k-Shape: Paparrizos, Gravano: k-Shape: Efficient and Accurate Clustering of Time Series, SIGMOD 2015.

namespace contact_shapelets::evaluation {

/// A distance between shapes and its shift.
struct ShapeDistance {
  double distance = 1.0;  ///< shape-based distance (SBD), in [0, 2]; 1 if all values of a series are zero
  int shift = 0;          ///< samples that move the second series right onto the first
};

/// Shape-based distances (equation 9 of the paper) of series of one length, by FFT.
class ShapeComparer {
 public:
  /// Compares series of `length` samples. \throws std::invalid_argument if length < 1.
  explicit ShapeComparer(int length);
  ~ShapeComparer();
  ShapeComparer(const ShapeComparer&) = delete;
  ShapeComparer& operator=(const ShapeComparer&) = delete;

  /// Returns the transforms of `series` [N, length], one per row. The functions below take them.
  Eigen::MatrixXcd Spectra(const Eigen::Ref<const Eigen::MatrixXd>& series) const;

  /// Returns SBD(x, y) = 1 - max_w CC_w(x, y) / (|x| |y|) over all shifts w, from the spectra and norms of the series.
  /// Of equally good shifts it takes the shortest; of two such, the one to the right.
  ShapeDistance Compare(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                        const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const;

  /// Returns the same distance without the shift, in less time.
  double Distance(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                  const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const;

 private:
  struct Plans;

  /// Writes the cross-correlations at all shifts, times the transform's length, into the plans' values. Returns the
  /// largest.
  double Correlate(const Eigen::Ref<const Eigen::RowVectorXcd>& x,
                   const Eigen::Ref<const Eigen::RowVectorXcd>& y) const;

  std::unique_ptr<Plans> plans_;
};

/// Returns the SBD of two series of equal length. \throws std::invalid_argument if lengths differ or are 0.
ShapeDistance CompareShapes(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y);

/// Returns `series` moved right by `shift` samples (left if negative). Zeros fill the gap.
Eigen::VectorXd Shifted(const Eigen::Ref<const Eigen::VectorXd>& series, int shift);

/// Returns the shape that `members` [n, m] have in common (section 3.2, algorithm 2 of the paper). Aligns each member x
/// to `reference` [m], unless that is zero. The shape is the leading eigenvector of Q^T S Q, z-normalised, with
/// S = sum x x^T and Q = I - 1 1^T / m; its product with the members' sum is positive. Returns zeros if all members are
/// constant.
Eigen::VectorXd ExtractShape(const Eigen::Ref<const Eigen::MatrixXd>& members,
                             const Eigen::Ref<const Eigen::VectorXd>& reference);

/// Parameters of KShape().
struct KShapeOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< random starts, at least 1; the result with the least inertia is kept
  int iterations = 100;    ///< greatest number of rounds per start, at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal results
};

/// A partition by shape.
struct KShapeResult {
  Eigen::MatrixXd centroids;  ///< [C, m], z-normalised
  Eigen::VectorXi labels;     ///< [N]
  double inertia = 0.0;       ///< sum of the distances to the assigned centroids
};

/// Clusters the rows of `series` [N, m], which are z-normalised (algorithm 3 of the paper). An empty cluster takes the
/// series farthest from its centroid. \throws std::invalid_argument if N < C or an option is out of range.
KShapeResult KShape(const Eigen::Ref<const Eigen::MatrixXd>& series, const KShapeOptions& options);

/// Returns the row of `centroids` [C, m] with the least SBD for each row of `series` [N, m].
Eigen::VectorXi NearestShapes(const Eigen::Ref<const Eigen::MatrixXd>& centroids,
                              const Eigen::Ref<const Eigen::MatrixXd>& series);

/// k-Shape as a method under evaluation, with its own clustering and its own nearest centroid.
class KShapeClusterer : public Clusterer {
 public:
  Eigen::VectorXi Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;
  Eigen::VectorXi Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;
  Eigen::VectorXi ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const override;

 private:
  KShapeOptions options_;
  int length_ = 0;
  Eigen::MatrixXd centroids_;
};

}  // namespace contact_shapelets::evaluation
