#pragma once

#include <Eigen/Core>

/// \file
/// The t-SNE layer of the paper (equation 4).

namespace contact_shapelets::core {

/// Returns the membership q of equation 4 with one degree of freedom (alpha = 1):
/// q_ik = (1 + F_ik)^-1 / sum_k (1 + F_ik)^-1. `distances` is F [N, K], one series per row, or F [K] of one series. q
/// has the same shape; each row, or the vector, sums to 1.
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
