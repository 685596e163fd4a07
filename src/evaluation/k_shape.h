#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// k-Shape: Paparrizos, Gravano: k-Shape: Efficient and Accurate Clustering of Time Series, SIGMOD 2015.

namespace contact_shapelets::evaluation {

/// A distance between shapes, and the shift that it was found at.
struct ShapeDistance {
  double distance = 1.0;  ///< SBD in [0, 2]; 1 where a series is zero throughout
  int shift = 0;          ///< samples by which the second series is to be moved right to lie on the first
};

/// Shape-based distances (equation 9 of the paper) of series of one length, by FFT.
class ShapeComparer {
 public:
  /// For series of `length` samples. \throws std::invalid_argument where length < 1.
  explicit ShapeComparer(int length);
  ~ShapeComparer();
  ShapeComparer(const ShapeComparer&) = delete;
  ShapeComparer& operator=(const ShapeComparer&) = delete;

  /// The transforms of `series` [N, length], one per row of the result, with which the functions below are given them.
  Eigen::MatrixXcd Spectra(const Eigen::Ref<const Eigen::MatrixXd>& series) const;

  /// SBD(x, y) = 1 - max_w CC_w(x, y) / (|x| |y|) over all shifts, from the series' spectra and norms; of equal shifts
  /// the shortest one, of those the one to the right.
  ShapeDistance Compare(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                        const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const;

  /// The same distance without the shift, which takes less time to find.
  double Distance(const Eigen::Ref<const Eigen::RowVectorXcd>& x, double x_norm,
                  const Eigen::Ref<const Eigen::RowVectorXcd>& y, double y_norm) const;

 private:
  struct Plans;

  /// Leaves the cross-correlations at all shifts in the plans' values, each times their number, and returns the
  /// largest.
  double Correlate(const Eigen::Ref<const Eigen::RowVectorXcd>& x,
                   const Eigen::Ref<const Eigen::RowVectorXcd>& y) const;

  std::unique_ptr<Plans> plans_;
};

/// SBD of two series of equal length. \throws std::invalid_argument where lengths differ or are 0.
ShapeDistance CompareShapes(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y);

/// `series` moved right by `shift` samples (left where negative), zeros where nothing is.
Eigen::VectorXd Shifted(const Eigen::Ref<const Eigen::VectorXd>& series, int shift);

/// The shape that `members` [n, m] have in common (section 3.2, algorithm 2 of the paper): each is aligned to
/// `reference` [m], unless that is zero; the leading eigenvector of Q^T S Q with S = sum x x^T, Q = I - 1 1^T / m, with
/// the sign that most members have, z-normalised. All zeros where all members are constant.
Eigen::VectorXd ExtractShape(const Eigen::Ref<const Eigen::MatrixXd>& members,
                             const Eigen::Ref<const Eigen::VectorXd>& reference);

/// Parameters of KShape().
struct KShapeOptions {
  int clusters = 2;        ///< C, at least 1
  int restarts = 20;       ///< random starts, the one of least summed distance is kept; at least 1
  int iterations = 100;    ///< rounds per start at the most, at least 1
  std::uint64_t seed = 0;  ///< equal seeds give equal results
};

/// A partition by shape.
struct KShapeResult {
  Eigen::MatrixXd centroids;  ///< [C, m], z-normalised
  Eigen::VectorXi labels;     ///< [N]
  double inertia = 0.0;       ///< sum of the distances to the assigned centroids
};

/// Clusters the rows of `series` [N, m], z-normalised (algorithm 3 of the paper). A cluster that empties takes the
/// series farthest from its centroid. \throws std::invalid_argument where N < C or an option is out of range.
KShapeResult KShape(const Eigen::Ref<const Eigen::MatrixXd>& series, const KShapeOptions& options);

/// For each row of `series` [N, m] the row of `centroids` [C, m] of least SBD.
Eigen::VectorXi NearestShapes(const Eigen::Ref<const Eigen::MatrixXd>& centroids,
                              const Eigen::Ref<const Eigen::MatrixXd>& series);

/// k-Shape as a method under evaluation: its own clustering, its own nearest centroid.
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
