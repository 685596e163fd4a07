#pragma once

#include <Eigen/Core>

/// \file
/// The objective of the paper (equation 6), term by term with its gradient. The contrastive weights keep it from
/// collapsing.

namespace contact_shapelets::core {

/// Returns the gradient of a loss L by F [N, K], given `distances` F, `membership` q and `membership_gradient` dL/dq,
/// all [N, K].
Eigen::MatrixXd DistanceGradient(const Eigen::Ref<const Eigen::MatrixXd>& distances,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership_gradient);

/// Returns |t_i - t_j|^2 of `series` [N, Q], one per row, in double precision: [N, N], symmetric, at least 0.
Eigen::MatrixXd SquaredDistances(const Eigen::Ref<const Eigen::MatrixXf>& series);

/// Returns the similarity of series G_ij = exp(-|t_i - t_j|^2 / sigma^2) [N, N], symmetric, with a diagonal of 1.
/// sigma^2 is the median squared distance of different series. `squared_distances` [N, N] is from SquaredDistances().
Eigen::MatrixXd GaussianSimilarity(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances);

/// Returns the weights of the paper, attraction alone: W = G with a diagonal of zero.
Eigen::MatrixXd PaperWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity);

/// Returns weights of attraction and repulsion: W = G / sum G - repulsion (1 - G) / sum (1 - G), both with a diagonal
/// of zero. `repulsion` is 0 or more.
///
/// The paper's term alone is least if all memberships are equal; the repulsion of unlike series keeps them apart.
Eigen::MatrixXd ContrastiveWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity, double repulsion);

/// A term of the objective with its gradient.
struct Term {
  double value = 0.0;
  Eigen::MatrixXd gradient;  ///< by the term's first argument, of the same shape
};

/// Returns the spectral term tr(q^T (D_W - W) q) of equation 5. D_W holds the row sums of W on its diagonal.
/// `membership` is q [N, K], `weights` is W [N, N], symmetric.
Term SpectralTerm(const Eigen::Ref<const Eigen::MatrixXd>& membership,
                  const Eigen::Ref<const Eigen::MatrixXd>& weights);

/// Returns the diversity term |H|_F^2 with H_kl = exp(-|s_k - s_l|^2 / sigma^2). `shapelets` [K, M] are s, one per row,
/// `variance` is sigma^2 > 0.
Term DiversityTerm(const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double variance);

/// Takes the proximal step of `amount` |s| for each value s: shrinks it towards zero by `amount` >= 0, and to exactly
/// zero if |s| is smaller (soft threshold).
void ShrinkToZero(double amount, Eigen::Ref<Eigen::MatrixXd> shapelets);

}  // namespace contact_shapelets::core
