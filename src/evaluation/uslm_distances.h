#pragma once

#include <Eigen/Core>

/// \file
/// The distances of USLM with their derivative.

namespace contact_shapelets::evaluation {

/// The windows of `series` [Q] of `length` samples, one per row: [Q - length + 1, length].
Eigen::MatrixXd Windows(const Eigen::Ref<const Eigen::VectorXd>& series, Eigen::Index length);

/// sum_j over series of `pull`_ij dX_ij/ds_i [K, M], for `pull` [K, N], the derivative of a function of X by X.
Eigen::MatrixXd PullThroughSoftMinimum(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                       const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness,
                                       const Eigen::Ref<const Eigen::MatrixXd>& pull);

}  // namespace contact_shapelets::evaluation
