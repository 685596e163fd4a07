#include "evaluation/k_shape.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/numerics/random.h"
#include "core/numerics/series.h"
#include "evaluation/data_set.h"

namespace contact_shapelets::evaluation {
namespace {

/// Returns the leading eigenvector of a symmetric matrix without negative eigenvalues. Power iteration from `start`
/// mostly converges within some ten rounds; a whole decomposition takes a hundred times as long. The iteration may end
/// at another eigenvector. An eigenvalue above half of the trace is certainly the largest; otherwise the matrix is
/// decomposed.
Eigen::VectorXd LeadingEigenvector(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& start) {
  constexpr int kRounds = 300;
  constexpr double kConverged = 1e-10;
  Eigen::VectorXd vector = start.normalized();
  for (int round = 0; round < kRounds && !vector.isZero(); ++round) {
    const Eigen::VectorXd product = matrix * vector;
    const double eigenvalue = vector.dot(product);
    const Eigen::VectorXd next = product.normalized();
    const double change = (next - vector).norm();
    vector = next;
    if (change >= kConverged) continue;
    if (eigenvalue > 0.5 * matrix.trace()) return vector;
    break;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvectors().rightCols(1);
}

/// Returns the direction of the leading right singular vector of `rows` [n, m], from the smaller of its Gram matrices.
Eigen::VectorXd LeadingDirection(const Eigen::MatrixXd& rows) {
  const Eigen::VectorXd sum = rows.colwise().sum().transpose();
  if (rows.rows() >= rows.cols()) return LeadingEigenvector(rows.transpose() * rows, sum);
  return rows.transpose() * LeadingEigenvector(rows * rows.transpose(), rows * sum);
}

/// Labels [N] and distances [N] to the nearest of `centroids`.
struct Assignment {
  Eigen::VectorXi labels;
  Eigen::VectorXd distances;
};

/// Series with their spectra and norms, which every comparison needs.
class ShapeSet {
 public:
  explicit ShapeSet(const Eigen::Ref<const Eigen::MatrixXd>& series)
      : series_(series),
        comparer_(static_cast<int>(series.cols())),
        spectra_(comparer_.Spectra(series)),
        norms_(series.rowwise().norm()) {}

  Assignment AssignTo(const Eigen::MatrixXd& centroids) const {
    const ShapeSpectraRows spectra = comparer_.Spectra(centroids);
    const Eigen::VectorXd norms = centroids.rowwise().norm();
    Assignment assignment;
    assignment.labels = Eigen::VectorXi::Zero(series_.rows());
    assignment.distances = Eigen::VectorXd::Constant(series_.rows(), std::numeric_limits<double>::infinity());
    for (Eigen::Index row = 0; row < series_.rows(); ++row) {
      for (Eigen::Index cluster = 0; cluster < centroids.rows(); ++cluster) {
        const double distance =
            comparer_.Distance(spectra_.row(row), norms_[row], spectra.row(cluster), norms[cluster]);
        if (distance >= assignment.distances[row]) continue;
        assignment.distances[row] = distance;
        assignment.labels[row] = static_cast<int>(cluster);
      }
    }
    return assignment;
  }

  Eigen::MatrixXd Members(const Eigen::VectorXi& labels, int cluster) const {
    Eigen::MatrixXd members((labels.array() == cluster).count(), series_.cols());
    Eigen::Index next = 0;
    for (Eigen::Index row = 0; row < series_.rows(); ++row) {
      if (labels[row] == cluster) members.row(next++) = series_.row(row);
    }
    return members;
  }

 private:
  using ShapeSpectraRows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  const Eigen::MatrixXd series_;
  ShapeComparer comparer_;
  ShapeSpectraRows spectra_;
  Eigen::VectorXd norms_;
};

/// Gives each empty cluster the series farthest from its centroid. No cluster loses its only series.
void RefillEmpty(int clusters, Assignment* assignment) {
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(clusters);
  for (Eigen::Index row = 0; row < assignment->labels.size(); ++row) ++counts[assignment->labels[row]];
  for (int cluster = 0; cluster < clusters; ++cluster) {
    if (counts[cluster] > 0) continue;
    Eigen::Index farthest = -1;
    for (Eigen::Index row = 0; row < assignment->labels.size(); ++row) {
      if (counts[assignment->labels[row]] < 2) continue;
      if (farthest < 0 || assignment->distances[row] > assignment->distances[farthest]) farthest = row;
    }
    --counts[assignment->labels[farthest]];
    assignment->labels[farthest] = cluster;
    assignment->distances[farthest] = 0.0;
    counts[cluster] = 1;
  }
}

/// Returns a random partition without empty clusters.
Eigen::VectorXi RandomLabels(int count, int clusters, core::Random* random) {
  const std::vector<int> order = random->Sample(count, count);
  Eigen::VectorXi labels(count);
  for (int place = 0; place < count; ++place) {
    labels[order[static_cast<std::size_t>(place)]] = place < clusters ? place : random->Index(clusters);
  }
  return labels;
}

KShapeResult KShapeFrom(const ShapeSet& set, Eigen::VectorXi labels, int length, const KShapeOptions& options) {
  KShapeResult result;
  result.centroids = Eigen::MatrixXd::Zero(options.clusters, length);
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    for (int cluster = 0; cluster < options.clusters; ++cluster) {
      result.centroids.row(cluster) =
          ExtractShape(set.Members(labels, cluster), result.centroids.row(cluster).transpose()).transpose();
    }
    Assignment assignment = set.AssignTo(result.centroids);
    RefillEmpty(options.clusters, &assignment);
    result.inertia = assignment.distances.sum();
    if (assignment.labels == labels) break;
    labels = assignment.labels;
  }
  result.labels = labels;
  return result;
}

}  // namespace

Eigen::VectorXd ExtractShape(const Eigen::Ref<const Eigen::MatrixXd>& members,
                             const Eigen::Ref<const Eigen::VectorXd>& reference) {
  Eigen::MatrixXd aligned = members;
  const double reference_norm = reference.norm();
  if (reference_norm > 0.0) {
    const ShapeComparer comparer(static_cast<int>(reference.size()));
    const Eigen::RowVectorXcd spectrum = comparer.Spectra(reference.transpose());
    for (Eigen::Index row = 0; row < members.rows(); ++row) {
      const Eigen::RowVectorXcd own = comparer.Spectra(members.row(row));
      const int shift = comparer.Compare(spectrum, reference_norm, own, members.row(row).norm()).shift;
      aligned.row(row) = Shifted(members.row(row).transpose(), shift).transpose();
    }
  }
  // Q^T S Q = Z^T Z. Z holds the aligned members minus their means.
  aligned.colwise() -= aligned.rowwise().mean().eval();
  Eigen::VectorXd shape = LeadingDirection(aligned);
  if ((aligned * shape).sum() < 0.0) shape = -shape;
  shape.array() -= shape.mean();
  const double deviation = std::sqrt(shape.squaredNorm() / static_cast<double>(shape.size()));
  if (aligned.isZero() || deviation <= 0.0) return Eigen::VectorXd::Zero(members.cols());
  return shape / deviation;
}

KShapeResult KShape(const Eigen::Ref<const Eigen::MatrixXd>& series, const KShapeOptions& options) {
  if (options.clusters < 1) throw std::invalid_argument("clusters must be at least 1");
  if (options.restarts < 1) throw std::invalid_argument("restarts must be at least 1");
  if (options.iterations < 1) throw std::invalid_argument("iterations must be at least 1");
  if (series.rows() < options.clusters) {
    throw std::invalid_argument("k-Shape was given " + std::to_string(series.rows()) + " series for " +
                                std::to_string(options.clusters) + " clusters");
  }
  const ShapeSet set(series);
  core::Random random(options.seed);
  KShapeResult best;
  best.inertia = std::numeric_limits<double>::infinity();
  for (int restart = 0; restart < options.restarts; ++restart) {
    const Eigen::VectorXi start = RandomLabels(static_cast<int>(series.rows()), options.clusters, &random);
    KShapeResult result = KShapeFrom(set, start, static_cast<int>(series.cols()), options);
    if (result.inertia < best.inertia) best = std::move(result);
  }
  return best;
}

Eigen::VectorXi NearestShapes(const Eigen::Ref<const Eigen::MatrixXd>& centroids,
                              const Eigen::Ref<const Eigen::MatrixXd>& series) {
  return ShapeSet(series).AssignTo(centroids).labels;
}

Eigen::VectorXi KShapeClusterer::Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  length_ = core::MedianLength(train);
  options_.clusters = clusters;
  options_.seed = seed;
  KShapeResult result = KShape(Transform(train).cast<double>(), options_);
  centroids_ = std::move(result.centroids);
  return result.labels;
}

Eigen::MatrixXf KShapeClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  return EqualLengthRows(series, length_);
}

Eigen::VectorXi KShapeClusterer::Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return NearestShapes(centroids_, features.cast<double>());
}

Eigen::VectorXi KShapeClusterer::ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return KShape(features.cast<double>(), options_).labels;
}

}  // namespace contact_shapelets::evaluation
