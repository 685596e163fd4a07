#include "core/learning/objective.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace contact_shapelets::core {

Eigen::MatrixXd DistanceGradient(const Eigen::Ref<const Eigen::MatrixXd>& distances,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership,
                                 const Eigen::Ref<const Eigen::MatrixXd>& membership_gradient) {
  // With g = 1 / (1 + F) and q = g / sum g: dq_l/dF_k = -(delta_kl - q_l) q_k / (1 + F_k).
  const Eigen::ArrayXd mean = (membership_gradient.array() * membership.array()).rowwise().sum();
  const Eigen::ArrayXXd centred = membership_gradient.array().colwise() - mean;
  return (-centred * membership.array() / (1.0 + distances.array())).matrix();
}

Eigen::MatrixXd SquaredDistances(const Eigen::Ref<const Eigen::MatrixXf>& series) {
  const Eigen::MatrixXd values = series.cast<double>();
  const Eigen::VectorXd energy = values.rowwise().squaredNorm();
  Eigen::MatrixXd squared = Eigen::MatrixXd::Zero(values.rows(), values.rows());
  squared.selfadjointView<Eigen::Lower>().rankUpdate(values, -2.0);
  squared.triangularView<Eigen::StrictlyUpper>() = squared.transpose();
  squared.colwise() += energy;
  squared.rowwise() += energy.transpose();
  return squared.cwiseMax(0.0);
}

Eigen::MatrixXd GaussianSimilarity(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances) {
  std::vector<double> different;
  different.reserve(static_cast<std::size_t>(squared_distances.rows()) *
                    static_cast<std::size_t>(squared_distances.rows()) / 2);
  for (Eigen::Index column = 1; column < squared_distances.cols(); ++column) {
    for (Eigen::Index row = 0; row < column; ++row) different.push_back(squared_distances(row, column));
  }
  if (different.empty()) return Eigen::MatrixXd::Ones(squared_distances.rows(), squared_distances.cols());
  const auto middle = different.begin() + static_cast<std::ptrdiff_t>(different.size() / 2);
  std::nth_element(different.begin(), middle, different.end());
  const double variance = std::max(*middle, 1e-12);
  Eigen::MatrixXd similarity = (-squared_distances.array() / variance).exp().matrix();
  similarity.diagonal().setOnes();
  return similarity;
}

Eigen::MatrixXd PaperWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity) {
  Eigen::MatrixXd weights = similarity;
  weights.diagonal().setZero();
  return weights;
}

Eigen::MatrixXd ContrastiveWeights(const Eigen::Ref<const Eigen::MatrixXd>& similarity, double repulsion) {
  Eigen::MatrixXd attraction = PaperWeights(similarity);
  Eigen::MatrixXd unlike = (1.0 - similarity.array()).matrix();
  unlike.diagonal().setZero();
  const double attraction_sum = std::max(attraction.sum(), 1e-12);
  const double unlike_sum = std::max(unlike.sum(), 1e-12);
  return attraction / attraction_sum - (repulsion / unlike_sum) * unlike;
}

Term SpectralTerm(const Eigen::Ref<const Eigen::MatrixXd>& membership,
                  const Eigen::Ref<const Eigen::MatrixXd>& weights) {
  const Eigen::VectorXd degree = weights.rowwise().sum();
  const Eigen::MatrixXd laplacian_product = degree.asDiagonal() * membership - weights * membership;
  Term term;
  term.value = membership.cwiseProduct(laplacian_product).sum();
  term.gradient = 2.0 * laplacian_product;
  return term;
}

Term DiversityTerm(const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double variance) {
  const Eigen::VectorXd energy = shapelets.rowwise().squaredNorm();
  Eigen::MatrixXd squared = -2.0 * shapelets * shapelets.transpose();
  squared.colwise() += energy;
  squared.rowwise() += energy.transpose();
  // H^2 = exp(-2 |s_k - s_l|^2 / variance). Each pair's gradient is -4 H^2 (s_k - s_l) / variance and counts twice.
  const Eigen::MatrixXd squared_similarity = (-2.0 * squared.array().max(0.0) / variance).exp().matrix();
  Term term;
  term.value = squared_similarity.sum();
  const Eigen::VectorXd degree = squared_similarity.rowwise().sum();
  term.gradient = (-8.0 / variance) * (degree.asDiagonal() * shapelets - squared_similarity * shapelets);
  return term;
}

void ShrinkToZero(double amount, Eigen::Ref<Eigen::MatrixXd> shapelets) {
  shapelets = shapelets.unaryExpr(
      [amount](double value) { return std::copysign(std::max(std::abs(value) - amount, 0.0), value); });
}

}  // namespace contact_shapelets::core
