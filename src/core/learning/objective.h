#pragma once

#include <Eigen/Core>

/// \file
/// The objective of the paper (equation 6), term by term with its gradient, and the contrastive weights that keep it
/// from collapsing.

namespace contact_shapelets::core {

/// Gradient of a loss by F [N, K], given `distances` F, `membership` q and `membership_gradient` dL/dq, all [N, K].
Eigen::MatrixXd DistanceGradient(const Eigen::Ref<const Eigen::MatrixXd>& distances,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership_gradient);

/// |t_i - t_j|^2 of `series` [N, Q], one per row, in double precision; returns [N, N], symmetric, at least 0.
Eigen::MatrixXd SquaredDistances(const Eigen::Ref<const Eigen::MatrixXf>& series);

/// Similarity of series: G_ij = exp(-|t_i - t_j|^2 / sigma^2), sigma^2 the median squared distance of different series.
/// `squared_distances` is [N, N], from SquaredDistances(); returns [N, N], symmetric, with a diagonal of 1.
Eigen::MatrixXd GaussianSimilarity(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances);

/// Attraction of the paper: W = G with a diagonal of zero.
Eigen::MatrixXd PaperWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity);

/// Attraction and repulsion: W = G / sum G - repulsion (1 - G) / sum (1 - G), both with a diagonal of zero.
///
/// The paper's term alone is least when all memberships are equal; the repulsion of unlike series keeps them apart.
/// `repulsion` is 0 or more.
Eigen::MatrixXd ContrastiveWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity, double repulsion);

/// A term of the objective with its gradient.
struct Term {
  double value = 0.0;
  Eigen::MatrixXd gradient;  ///< by the term's argument, of the same shape
};

/// Spectral term tr(q^T (D_W - W) q) of equation 5, D_W the row sums of W. `membership` q is [N, K] (also the
/// gradient's shape), `weights` W is [N, N] and symmetric.
Term SpectralTerm(const Eigen::Ref<const Eigen::MatrixXd>& membership,
                  const Eigen::Ref<const Eigen::MatrixXd>& weights);

/// Diversity term |H|_F^2, H_kl = exp(-|s_k - s_l|^2 / sigma^2), `shapelets` [K, M] in rows, `variance` sigma^2 > 0.
Term DiversityTerm(const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double variance);

/// The proximal step of `amount` |s| for each value: shrinks it towards zero by `amount` >= 0, and to exactly zero
/// where it is smaller (soft threshold).
void ShrinkToZero(double amount, Eigen::Ref<Eigen::MatrixXd> shapelets);

}  // namespace contact_shapelets::core
