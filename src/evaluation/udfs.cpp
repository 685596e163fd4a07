#include "evaluation/udfs.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/numerics/series.h"
#include "evaluation/data_set.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns `point` and its `count` nearest neighbours among the rows of `points`, as columns: X_i [D, k + 1].
Eigen::MatrixXd Neighbourhood(const Eigen::Ref<const Eigen::MatrixXd>& points, Eigen::Index point, int count) {
  const Eigen::VectorXd distances = (points.rowwise() - points.row(point)).rowwise().squaredNorm();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::swap(order[0], order[static_cast<std::size_t>(point)]);
  std::partial_sort(order.begin() + 1, order.begin() + 1 + count, order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
  });
  Eigen::MatrixXd neighbourhood(points.cols(), count + 1);
  for (int column = 0; column <= count; ++column) {
    neighbourhood.col(column) = points.row(order[static_cast<std::size_t>(column)]).transpose();
  }
  return neighbourhood;
}

/// Returns M, the sum of the local discriminative scores.
Eigen::MatrixXd LocalScores(const Eigen::Ref<const Eigen::MatrixXd>& points, const UdfsOptions& options) {
  const int count = std::min(options.neighbours, static_cast<int>(points.rows()) - 1);
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(points.cols(), points.cols());
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    Eigen::MatrixXd centred = Neighbourhood(points, point, count);
    centred.colwise() -= centred.rowwise().mean().eval();
    Eigen::MatrixXd gram = centred.transpose() * centred;
    gram.diagonal().array() += options.ridge;
    // X_i H B_i H X_i^T = Z^T Z with Z = L^-1 (X_i H)^T, which keeps M symmetric.
    const Eigen::MatrixXd half = gram.llt().matrixL().solve(centred.transpose());
    scores.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
  }
  return scores.selfadjointView<Eigen::Lower>();
}

void CheckOptions(const Eigen::Ref<const Eigen::MatrixXd>& points, int clusters, const UdfsOptions& options) {
  if (points.rows() < 2) throw std::invalid_argument("UDFS needs at least 2 points");
  if (clusters < 1 || points.cols() < clusters) {
    throw std::invalid_argument("UDFS needs at least as many features as clusters");
  }
  if (options.neighbours < 1) throw std::invalid_argument("neighbours must be at least 1");
  if (!(options.ridge > 0.0)) throw std::invalid_argument("ridge must be above 0");
  if (!(options.sparsity > 0.0)) throw std::invalid_argument("sparsity must be above 0");
  if (options.iterations < 1) throw std::invalid_argument("iterations must be at least 1");
  if (!(options.kept_part > 0.0 && options.kept_part <= 1.0)) {
    throw std::invalid_argument("kept_part must be in (0, 1]");
  }
}

}  // namespace

UdfsResult SelectFeatures(const Eigen::Ref<const Eigen::MatrixXd>& points, int clusters, const UdfsOptions& options) {
  CheckOptions(points, clusters, options);
  constexpr double kLeastLength = 1e-9;
  constexpr double kEnoughProgress = 1e-7;
  const Eigen::MatrixXd scores = LocalScores(points, options);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Ones(points.cols());
  UdfsResult result;
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    Eigen::MatrixXd weighted = scores;
    weighted.diagonal() += options.sparsity * diagonal;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(weighted);
    const Eigen::MatrixXd projection = solver.eigenvectors().leftCols(clusters);
    result.weights = projection.rowwise().norm();
    diagonal = 0.5 * result.weights.array().max(kLeastLength).inverse();
    const double objective =
        (projection.transpose() * scores * projection).trace() + options.sparsity * result.weights.sum();
    result.objectives.push_back(objective);
    const std::size_t rounds = result.objectives.size();
    if (rounds > 1 && result.objectives[rounds - 2] - objective < kEnoughProgress * std::abs(objective)) break;
  }
  return result;
}

void UdfsClusterer::Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t /*seed*/) {
  length_ = core::MedianLength(train);
  const Eigen::MatrixXd points = EqualLengthRows(train, length_).cast<double>();
  const Eigen::VectorXd weights = SelectFeatures(points, clusters, options_).weights;
  const int count = std::max(1, static_cast<int>(std::lround(options_.kept_part * length_)));
  kept_.resize(static_cast<std::size_t>(length_));
  std::iota(kept_.begin(), kept_.end(), 0);
  std::stable_sort(kept_.begin(), kept_.end(), [&](int a, int b) { return weights[a] > weights[b]; });
  kept_.resize(static_cast<std::size_t>(count));
  std::sort(kept_.begin(), kept_.end());
}

Eigen::MatrixXf UdfsClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  const Eigen::MatrixXf rows = EqualLengthRows(series, length_);
  Eigen::MatrixXf features(rows.rows(), static_cast<Eigen::Index>(kept_.size()));
  for (std::size_t column = 0; column < kept_.size(); ++column) {
    features.col(static_cast<Eigen::Index>(column)) = rows.col(kept_[column]);
  }
  return features;
}

}  // namespace contact_shapelets::evaluation
