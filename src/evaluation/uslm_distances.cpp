#include "evaluation/uslm_distances.h"

#include "evaluation/uslm.h"

namespace contact_shapelets::evaluation {
namespace {

/// Distances d [J, K] of all windows to all shapelets, and their weights in the soft minimum. The weights of each
/// shapelet sum to 1.
struct WindowDistances {
  Eigen::MatrixXd values;
  Eigen::MatrixXd weights;
};

WindowDistances Compare(const Eigen::MatrixXd& windows, const Eigen::Ref<const Eigen::MatrixXd>& shapelets,
                        double softness) {
  WindowDistances distances;
  distances.values = -2.0 * windows * shapelets.transpose();
  distances.values.colwise() += windows.rowwise().squaredNorm();
  distances.values.rowwise() += shapelets.rowwise().squaredNorm().transpose();
  distances.values = distances.values.cwiseMax(0.0) / static_cast<double>(shapelets.cols());
  // Relative to the least distance, so that not all exponentials can underflow.
  const Eigen::RowVectorXd least = distances.values.colwise().minCoeff();
  distances.weights = (softness * (distances.values.rowwise() - least)).array().exp();
  const Eigen::RowVectorXd sums = distances.weights.colwise().sum();
  distances.weights.array().rowwise() /= sums.array();
  return distances;
}

}  // namespace

Eigen::MatrixXd Windows(const Eigen::Ref<const Eigen::VectorXd>& series, Eigen::Index length) {
  Eigen::MatrixXd windows(series.size() - length + 1, length);
  for (Eigen::Index column = 0; column < length; ++column) {
    windows.col(column) = series.segment(column, windows.rows());
  }
  return windows;
}

Eigen::MatrixXd SoftMinimumDistances(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                     const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness) {
  Eigen::MatrixXd minima(shapelets.rows(), series.rows());
  for (Eigen::Index row = 0; row < series.rows(); ++row) {
    const WindowDistances distances =
        Compare(Windows(series.row(row).transpose(), shapelets.cols()), shapelets, softness);
    minima.col(row) = distances.values.cwiseProduct(distances.weights).colwise().sum().transpose();
  }
  return minima;
}

Eigen::MatrixXd PullThroughSoftMinimum(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                       const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness,
                                       const Eigen::Ref<const Eigen::MatrixXd>& pull) {
  // dX/dd_w = weight_w (1 + alpha (d_w - X)), dd_w/ds = 2 (s - t_w) / M.
  Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(shapelets.rows(), shapelets.cols());
  for (Eigen::Index row = 0; row < series.rows(); ++row) {
    const Eigen::MatrixXd windows = Windows(series.row(row).transpose(), shapelets.cols());
    const WindowDistances distances = Compare(windows, shapelets, softness);
    const Eigen::RowVectorXd minima = distances.values.cwiseProduct(distances.weights).colwise().sum();
    Eigen::MatrixXd parts = (1.0 + softness * (distances.values.rowwise() - minima).array()).matrix();
    parts = parts.cwiseProduct(distances.weights) * pull.col(row).asDiagonal();
    gradient += parts.colwise().sum().asDiagonal() * shapelets;
    gradient -= parts.transpose() * windows;
  }
  return 2.0 / static_cast<double>(shapelets.cols()) * gradient;
}

}  // namespace contact_shapelets::evaluation
