#include "evaluation/uslm.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/clustering/kmeans.h"
#include "core/learning/learner.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"
#include "evaluation/data_set.h"
#include "evaluation/uslm_distances.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns the squared Euclidean distances [N, N] between the columns of `points` [D, N].
Eigen::MatrixXd SquaredDistances(const Eigen::MatrixXd& points) {
  const Eigen::VectorXd energy = points.colwise().squaredNorm().transpose();
  Eigen::MatrixXd distances = -2.0 * points.transpose() * points;
  distances.colwise() += energy;
  distances.rowwise() += energy.transpose();
  return distances.cwiseMax(0.0);
}

/// Returns the median squared distance between different columns of `points`; 1 if it is 0.
double MedianSquaredDistance(const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd distances = SquaredDistances(points);
  std::vector<double> values;
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    for (Eigen::Index column = 0; column < row; ++column) values.push_back(distances(row, column));
  }
  if (values.empty()) return 1.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle > 0.0 ? *middle : 1.0;
}

/// Returns G of the columns of `points`, with a diagonal of zero: Laplacians do not depend on it.
Eigen::MatrixXd Similarity(const Eigen::MatrixXd& points, double width) {
  Eigen::MatrixXd similarity = (-SquaredDistances(points) / width).array().exp();
  similarity.diagonal().setZero();
  return similarity;
}

Eigen::MatrixXd Laplacian(const Eigen::MatrixXd& similarity) {
  Eigen::MatrixXd laplacian = -similarity;
  laplacian.diagonal() += similarity.rowwise().sum();
  return laplacian;
}

/// Returns K-means centroids [count, length] of up to 3000 windows of `series`, drawn at random.
Eigen::MatrixXd StartingShapelets(const Eigen::Ref<const Eigen::MatrixXd>& series, int length, int count,
                                  std::uint64_t seed) {
  constexpr int kMostWindows = 3000;
  const int per_series = static_cast<int>(series.cols()) - length + 1;
  const int all = per_series * static_cast<int>(series.rows());
  core::Random random(seed);
  const std::vector<int> chosen = random.Sample(all, std::min(all, kMostWindows));
  Eigen::MatrixXf windows(chosen.size(), length);
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    windows.row(static_cast<Eigen::Index>(row)) =
        series.row(chosen[row] / per_series).segment(chosen[row] % per_series, length).cast<float>();
  }
  core::KMeansOptions options;
  options.clusters = count;
  options.restarts = 2;
  options.iterations = 30;
  options.seed = seed;
  return core::KMeans(windows, options).centroids.cast<double>();
}

void CheckOptions(const UslmOptions& options) {
  if (!(options.scale > 0.0 && options.scale < 1.0)) throw std::invalid_argument("scale must be in (0, 1)");
  if (!(options.softness < 0.0)) throw std::invalid_argument("softness must be below 0");
  if (!(options.diversity >= 0.0)) throw std::invalid_argument("diversity must be at least 0");
  if (!(options.regression > 0.0)) throw std::invalid_argument("regression must be above 0");
  if (!(options.classifier > 0.0)) throw std::invalid_argument("classifier must be above 0");
  if (options.rounds < 1) throw std::invalid_argument("rounds must be at least 1");
}

}  // namespace

UslmLearner::UslmLearner(const Eigen::Ref<const Eigen::MatrixXd>& series, int clusters, const UslmOptions& options,
                         std::uint64_t seed)
    : options_(options), clusters_(clusters), series_(series) {
  CheckOptions(options);
  const auto count = static_cast<int>(series.rows());
  const auto length = static_cast<int>(series.cols());
  if (clusters < 1 || count <= clusters) throw std::invalid_argument("USLM needs more series than clusters");
  const int window = std::clamp(static_cast<int>(std::lround(options.scale * length)), 2, std::max(2, length));
  if (window > length) throw std::invalid_argument("USLM needs series of at least 2 values");
  shapelets_ = StartingShapelets(series, window, core::ShapeletCount(count, length, window, clusters), seed);
  distances_ = SoftMinimumDistances(series_, shapelets_, options_.softness);
  graph_width_ = MedianSquaredDistance(distances_);
  diversity_width_ = MedianSquaredDistance(shapelets_.transpose());
  UpdatePseudoLabels();
  UpdateClassifier();
}

void UslmLearner::UpdatePseudoLabels() {
  Eigen::MatrixXd inner = options_.regression * distances_ * distances_.transpose();
  inner.diagonal().array() += options_.classifier;
  Eigen::MatrixXd problem = Laplacian(Similarity(distances_, graph_width_));
  problem.diagonal().array() += options_.regression;
  problem -= options_.regression * options_.regression * distances_.transpose() * inner.llt().solve(distances_);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (problem + problem.transpose()));
  pseudo_labels_ = solver.eigenvectors().leftCols(clusters_).transpose();
}

void UslmLearner::UpdateClassifier() {
  Eigen::MatrixXd inner = options_.regression * distances_ * distances_.transpose();
  inner.diagonal().array() += options_.classifier;
  classifier_ = inner.llt().solve(options_.regression * distances_ * pseudo_labels_.transpose());
}

bool UslmLearner::UpdateShapelets() {
  constexpr double kArmijo = 1e-4;
  constexpr int kMostHalvings = 40;
  const double before = Objective();
  const Eigen::MatrixXd gradient = ShapeletGradient();
  const double slope = gradient.squaredNorm();
  if (slope <= 0.0) return false;
  step_ *= 4.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, step_ *= 0.5) {
    const Eigen::MatrixXd moved = shapelets_ - step_ * gradient;
    const Eigen::MatrixXd distances = SoftMinimumDistances(series_, moved, options_.softness);
    if (!(ObjectiveAt(moved, distances) <= before - kArmijo * step_ * slope)) continue;
    shapelets_ = moved;
    distances_ = distances;
    return true;
  }
  return false;
}

void UslmLearner::Learn() {
  constexpr double kEnoughProgress = 1e-5;
  double last = Objective();
  for (int round = 0; round < options_.rounds; ++round) {
    UpdatePseudoLabels();
    UpdateClassifier();
    if (!UpdateShapelets()) break;
    const double objective = Objective();
    if (last - objective < kEnoughProgress * std::abs(last)) break;
    last = objective;
  }
}

double UslmLearner::Objective() const { return ObjectiveAt(shapelets_, distances_); }

double UslmLearner::ObjectiveAt(const Eigen::MatrixXd& shapelets, const Eigen::MatrixXd& distances) const {
  const Eigen::MatrixXd laplacian = Laplacian(Similarity(distances, graph_width_));
  const double spectral = (pseudo_labels_ * laplacian).cwiseProduct(pseudo_labels_).sum();
  const double error = (classifier_.transpose() * distances - pseudo_labels_).squaredNorm();
  return 0.5 * (spectral + options_.diversity * ShapeletSimilarity(shapelets).squaredNorm() +
                options_.regression * error + options_.classifier * classifier_.squaredNorm());
}

Eigen::MatrixXd UslmLearner::ShapeletSimilarity(const Eigen::MatrixXd& shapelets) const {
  return Similarity(shapelets.transpose(), diversity_width_);
}

Eigen::MatrixXd UslmLearner::ShapeletGradient() const {
  // 1/2 tr(Y L Y^T) = 1/4 sum_ij A_ij with A_ij = G_ij |y_i - y_j|^2. Its derivative by x_i is
  // -1/sigma^2 sum_j A_ij (x_i - x_j), column i of -X times the Laplacian of A, divided by sigma^2.
  const Eigen::MatrixXd pairs = Similarity(distances_, graph_width_).cwiseProduct(SquaredDistances(pseudo_labels_));
  Eigen::MatrixXd pull = -distances_ * Laplacian(pairs) / graph_width_;
  pull += options_.regression * classifier_ * (classifier_.transpose() * distances_ - pseudo_labels_);
  Eigen::MatrixXd gradient = PullThroughSoftMinimum(series_, shapelets_, options_.softness, pull);
  // The derivative of lambda1/2 |H|^2 by s_i is -4 lambda1 / sigma_H^2 sum_j H_ij^2 (s_i - s_j).
  const Eigen::MatrixXd squared = ShapeletSimilarity(shapelets_).cwiseAbs2();
  gradient -= 4.0 * options_.diversity / diversity_width_ * Laplacian(squared) * shapelets_;
  return gradient;
}

void UslmLearner::set_shapelets(const Eigen::Ref<const Eigen::MatrixXd>& shapelets) {
  if (shapelets.rows() != shapelets_.rows() || shapelets.cols() != shapelets_.cols()) {
    throw std::invalid_argument("the shapelets have another size");
  }
  shapelets_ = shapelets;
  distances_ = SoftMinimumDistances(series_, shapelets_, options_.softness);
}

void UslmLearner::set_classifier(const Eigen::Ref<const Eigen::MatrixXd>& classifier) {
  if (classifier.rows() != classifier_.rows() || classifier.cols() != classifier_.cols()) {
    throw std::invalid_argument("the classifier has another size");
  }
  classifier_ = classifier;
}

Eigen::MatrixXf UslmClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  const Eigen::MatrixXd rows = EqualLengthRows(series, length_).cast<double>();
  return SoftMinimumDistances(rows, shapelets_, options_.softness).transpose().cast<float>();
}

void UslmClusterer::Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  length_ = core::MedianLength(train);
  UslmLearner learner(EqualLengthRows(train, length_).cast<double>(), clusters, options_, seed);
  learner.Learn();
  shapelets_ = learner.shapelets();
}

}  // namespace contact_shapelets::evaluation
