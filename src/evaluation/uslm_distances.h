#pragma once

#include <Eigen/Core>

/// \file
/// The distances of USLM and their derivative.

namespace contact_shapelets::evaluation {

/// Returns the windows of `length` samples of `series` [Q], one per row: [Q - length + 1, length].
Eigen::MatrixXd Windows(const Eigen::Ref<const Eigen::VectorXd>& series, Eigen::Index length);

/// Returns the derivative [K, M] of a function of X by the shapelets s_i: sum_j pull_ij dX_ij/ds_i. `pull` [K, N] is
/// its derivative by X.
Eigen::MatrixXd PullThroughSoftMinimum(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                       const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness,
                                       const Eigen::Ref<const Eigen::MatrixXd>& pull);

}  // namespace contact_shapelets::evaluation
