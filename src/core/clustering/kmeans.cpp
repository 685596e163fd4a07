#include "core/clustering/kmeans.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns |c|^2 - 2 p^T c [N, C] for points p [N, D] and centroids c [C, D]: their squared distances without the
/// |p|^2, which do not matter for the nearest centroid.
Eigen::MatrixXf RelativeDistances(const RowMajor& points, const Eigen::Ref<const Eigen::MatrixXf>& centroids) {
  Eigen::MatrixXf distances = -2.0F * (points * centroids.transpose());
  distances.rowwise() += centroids.rowwise().squaredNorm().transpose();
  return distances;
}

Eigen::MatrixXf PlusPlusStart(const RowMajor& points, int clusters, Random* random) {
  Eigen::MatrixXf centroids(clusters, points.cols());
  centroids.row(0) = points.row(random->Index(static_cast<int>(points.rows())));
  Eigen::VectorXd nearest = (points.rowwise() - centroids.row(0)).rowwise().squaredNorm().cast<double>();
  for (int cluster = 1; cluster < clusters; ++cluster) {
    double left = random->Uniform() * nearest.sum();
    Eigen::Index chosen = 0;
    while (chosen + 1 < nearest.size() && (left -= nearest[chosen]) >= 0.0) ++chosen;
    centroids.row(cluster) = points.row(chosen);
    nearest = nearest.cwiseMin((points.rowwise() - centroids.row(cluster)).rowwise().squaredNorm().cast<double>());
  }
  return centroids;
}

/// Sets centroids to the means of the clusters' points. An empty cluster takes the point farthest from its centroid.
void UpdateCentroids(const RowMajor& points, Eigen::VectorXi* labels, Eigen::MatrixXf* centroids) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(centroids->rows(), centroids->cols());
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(centroids->rows());
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    sums.row((*labels)[row]) += points.row(row).cast<double>();
    ++counts[(*labels)[row]];
  }
  for (Eigen::Index cluster = 0; cluster < counts.size(); ++cluster) {
    if (counts[cluster] > 0) continue;
    Eigen::Index farthest = -1;
    float distance = -1.0F;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      if (counts[(*labels)[row]] < 2) continue;
      const float own = (points.row(row) - centroids->row((*labels)[row])).squaredNorm();
      if (farthest < 0 || own > distance) {
        distance = own;
        farthest = row;
      }
    }
    sums.row((*labels)[farthest]) -= points.row(farthest).cast<double>();
    --counts[(*labels)[farthest]];
    (*labels)[farthest] = static_cast<int>(cluster);
    sums.row(cluster) = points.row(farthest).cast<double>();
    counts[cluster] = 1;
  }
  for (Eigen::Index cluster = 0; cluster < counts.size(); ++cluster) {
    centroids->row(cluster) = (sums.row(cluster) / counts[cluster]).cast<float>();
  }
}

Eigen::VectorXi LeastInEachRow(const Eigen::MatrixXf& distances) {
  Eigen::VectorXi least(distances.rows());
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    Eigen::Index column = 0;
    distances.row(row).minCoeff(&column);
    least[row] = static_cast<int>(column);
  }
  return least;
}

KMeansResult LloydFrom(const RowMajor& points, Eigen::MatrixXf centroids, int iterations) {
  KMeansResult result;
  result.labels = Eigen::VectorXi::Constant(points.rows(), -1);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Eigen::VectorXi labels = LeastInEachRow(RelativeDistances(points, centroids));
    if (labels == result.labels) break;
    result.labels = labels;
    UpdateCentroids(points, &result.labels, &centroids);
  }
  result.inertia = 0.0;
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    result.inertia += static_cast<double>((points.row(row) - centroids.row(result.labels[row])).squaredNorm());
  }
  result.centroids = std::move(centroids);
  return result;
}

void NumberByFirstPoint(KMeansResult* result) {
  std::vector<int> number(static_cast<std::size_t>(result->centroids.rows()), -1);
  int next = 0;
  for (Eigen::Index item = 0; item < result->labels.size(); ++item) {
    int& renamed = number[static_cast<std::size_t>(result->labels[item])];
    if (renamed < 0) renamed = next++;
    result->labels[item] = renamed;
  }
  Eigen::MatrixXf ordered = result->centroids;
  for (std::size_t cluster = 0; cluster < number.size(); ++cluster) {
    if (number[cluster] < 0) number[cluster] = next++;
    ordered.row(number[cluster]) = result->centroids.row(static_cast<Eigen::Index>(cluster));
  }
  result->centroids = ordered;
}

}  // namespace

KMeansResult KMeans(const Eigen::Ref<const Eigen::MatrixXf>& points, const KMeansOptions& options) {
  if (options.clusters < 1) throw std::invalid_argument("clusters must be at least 1");
  if (options.restarts < 1) throw std::invalid_argument("restarts must be at least 1");
  if (options.iterations < 1) throw std::invalid_argument("iterations must be at least 1");
  if (points.rows() < options.clusters) {
    throw std::invalid_argument("K-means was given " + std::to_string(points.rows()) + " points for " +
                                std::to_string(options.clusters) + " clusters");
  }
  if (!points.allFinite()) throw std::invalid_argument("a point of K-means holds a value that is not finite");
  // Points near the origin keep the most digits in squared distances.
  const Eigen::RowVectorXf middle = points.cast<double>().colwise().mean().cast<float>();
  const RowMajor rows = points.rowwise() - middle;
  Random random(options.seed);
  KMeansResult best;
  for (int restart = 0; restart < options.restarts; ++restart) {
    KMeansResult result = LloydFrom(rows, PlusPlusStart(rows, options.clusters, &random), options.iterations);
    if (restart == 0 || result.inertia < best.inertia) best = std::move(result);
  }
  best.centroids.rowwise() += middle;
  NumberByFirstPoint(&best);
  return best;
}

int NearestCentroid(const Eigen::Ref<const Eigen::MatrixXf>& centroids,
                    const Eigen::Ref<const Eigen::VectorXf>& point) {
  Eigen::Index nearest = 0;
  (centroids.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

Eigen::VectorXi NearestCentroids(const Eigen::Ref<const Eigen::MatrixXf>& centroids,
                                 const Eigen::Ref<const Eigen::MatrixXf>& points) {
  const Eigen::RowVectorXf middle = centroids.colwise().mean();
  return LeastInEachRow(RelativeDistances(points.rowwise() - middle, centroids.rowwise() - middle));
}

}  // namespace contact_shapelets::core
