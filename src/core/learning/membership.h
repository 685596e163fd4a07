#pragma once

#include <Eigen/Core>

/// \file
/// Equation 4 of the paper, the t-SNE layer.

namespace contact_shapelets::core {

/// Membership q of equation 4 with one degree of freedom (alpha = 1): q_ik = (1 + F_ik)^-1 / sum_k (1 + F_ik)^-1.
/// `distances` is F [N, K], one series per row, or F [K] of one series; returns q of the same shape. Each row, or the
/// vector, sums to 1.
template <typename Derived>
typename Derived::PlainObject Membership(const Eigen::MatrixBase<Derived>& distances) {
  using Scalar = typename Derived::Scalar;
  typename Derived::PlainObject membership = (Scalar(1) + distances.array()).inverse().matrix();
  if constexpr (Derived::IsVectorAtCompileTime) {
    membership /= membership.sum();
  } else {
    membership.array().colwise() /= membership.rowwise().sum().array().eval();
  }
  return membership;
}

}  // namespace contact_shapelets::core
