#include "evaluation/dtw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/numerics/random.h"
#include "core/numerics/series.h"
#include "evaluation/data_set.h"

namespace contact_shapelets::evaluation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Assigns each item to its nearest medoid, the first one of a tie.
double AssignToMedoids(const Eigen::Ref<const Eigen::MatrixXd>& distances, const std::vector<int>& medoids,
                       Eigen::VectorXi* labels) {
  double cost = 0.0;
  for (Eigen::Index item = 0; item < distances.rows(); ++item) {
    double least = kInfinity;
    for (std::size_t index = 0; index < medoids.size(); ++index) {
      const double distance = distances(item, medoids[index]);
      if (distance >= least) continue;
      least = distance;
      (*labels)[item] = static_cast<int>(index);
    }
    cost += least;
  }
  return cost;
}

/// The member of cluster `label` with the least summed distance to the others. Each cluster has its own medoid at
/// least.
int BestMedoid(const Eigen::Ref<const Eigen::MatrixXd>& distances, const Eigen::VectorXi& labels, int label) {
  int best = -1;
  double least = kInfinity;
  for (int member = 0; member < labels.size(); ++member) {
    if (labels[member] != label) continue;
    const double sum = (labels.array() == label).select(distances.col(member).array(), 0.0).sum();
    if (sum >= least) continue;
    least = sum;
    best = member;
  }
  return best;
}

KMedoidsResult KMedoidsFrom(const Eigen::Ref<const Eigen::MatrixXd>& distances, std::vector<int> start,
                            int iterations) {
  KMedoidsResult result;
  result.medoids = std::move(start);
  result.labels = Eigen::VectorXi::Zero(distances.rows());
  result.cost = AssignToMedoids(distances, result.medoids, &result.labels);
  for (int round = 0; round < iterations; ++round) {
    std::vector<int> moved = result.medoids;
    for (std::size_t index = 0; index < moved.size(); ++index) {
      const int best = BestMedoid(distances, result.labels, static_cast<int>(index));
      // Two equal items may both be medoids: the second one then has no member.
      if (best >= 0) moved[index] = best;
    }
    Eigen::VectorXi labels = result.labels;
    const double cost = AssignToMedoids(distances, moved, &labels);
    if (cost >= result.cost) break;
    result = {std::move(moved), std::move(labels), cost};
  }
  return result;
}

}  // namespace

double DtwDistance(const Eigen::Ref<const Eigen::VectorXf>& x, const Eigen::Ref<const Eigen::VectorXf>& y, int band) {
  if (x.size() != y.size() || x.size() < 1) {
    throw std::invalid_argument("dynamic time warping needs two series of one length of at least 1");
  }
  const auto length = static_cast<int>(x.size());
  std::vector<double> last(static_cast<std::size_t>(length) + 1, kInfinity);
  std::vector<double> now(last);
  last[0] = 0.0;
  for (int row = 1; row <= length; ++row) {
    const int first = std::max(1, row - band);
    const int end = std::min(length, row + band);
    now[first - 1] = kInfinity;
    for (int column = first; column <= end; ++column) {
      const double difference = static_cast<double>(x[row - 1]) - static_cast<double>(y[column - 1]);
      const double before = std::min({last[column - 1], last[column], now[column - 1]});
      now[column] = difference * difference + before;
    }
    if (end < length) now[end + 1] = kInfinity;
    std::swap(last, now);
  }
  return std::sqrt(last[length]);
}

KMedoidsResult KMedoids(const Eigen::Ref<const Eigen::MatrixXd>& distances, int clusters, const DtwOptions& options,
                        std::uint64_t seed) {
  if (clusters < 1 || distances.rows() < clusters) throw std::invalid_argument("there are fewer series than clusters");
  if (options.restarts < 1 || options.iterations < 1) {
    throw std::invalid_argument("restarts and iterations must be at least 1");
  }
  core::Random random(seed);
  KMedoidsResult best;
  best.cost = kInfinity;
  for (int restart = 0; restart < options.restarts; ++restart) {
    const std::vector<int> start = random.Sample(static_cast<int>(distances.rows()), clusters);
    KMedoidsResult result = KMedoidsFrom(distances, start, options.iterations);
    if (result.cost < best.cost) best = std::move(result);
  }
  return best;
}

Eigen::VectorXi DtwClusterer::Fit(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) {
  clusters_ = clusters;
  seed_ = seed;
  length_ = core::MedianLength(train);
  const Eigen::MatrixXf rows = Transform(train);
  const KMedoidsResult result = KMedoids(AllDistances(rows), clusters, options_, seed);
  medoids_.resize(clusters, length_);
  for (int index = 0; index < clusters; ++index) medoids_.row(index) = rows.row(result.medoids[index]);
  return result.labels;
}

Eigen::MatrixXf DtwClusterer::Transform(const std::vector<Eigen::VectorXf>& series) const {
  return EqualLengthRows(series, length_);
}

Eigen::VectorXi DtwClusterer::Assign(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  Eigen::VectorXi labels(features.rows());
  for (Eigen::Index row = 0; row < features.rows(); ++row) {
    Eigen::VectorXd distances(medoids_.rows());
    for (Eigen::Index index = 0; index < medoids_.rows(); ++index) {
      distances[index] = DtwDistance(features.row(row).transpose(), medoids_.row(index).transpose(), Band());
    }
    distances.minCoeff(&labels[row]);
  }
  return labels;
}

Eigen::VectorXi DtwClusterer::ClusterAnew(const Eigen::Ref<const Eigen::MatrixXf>& features) const {
  return KMedoids(AllDistances(features), clusters_, options_, seed_).labels;
}

int DtwClusterer::Band() const { return static_cast<int>(std::ceil(options_.band * length_)); }

Eigen::MatrixXd DtwClusterer::AllDistances(const Eigen::Ref<const Eigen::MatrixXf>& rows) const {
  // One series per column, so that each is contiguous.
  const Eigen::MatrixXf series = rows.transpose();
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(series.cols(), series.cols());
  for (Eigen::Index one = 0; one < series.cols(); ++one) {
    for (Eigen::Index other = one + 1; other < series.cols(); ++other) {
      distances(one, other) = distances(other, one) = DtwDistance(series.col(one), series.col(other), Band());
    }
  }
  return distances;
}

}  // namespace contact_shapelets::evaluation
