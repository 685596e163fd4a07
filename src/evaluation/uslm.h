#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// USLM: Zhang, Wu, Yang, Tian, Zhang: Unsupervised Feature Learning from Time Series, IJCAI 2016 (also USSL, TPAMI
/// 2019). Shapelets, pseudo-labels and a linear classifier between them are learned in turn.

namespace contact_shapelets::evaluation {

/// Parameters of UslmLearner.
struct UslmOptions {
  double scale = 0.2;        ///< length of the shapelets as a part of the series', (0, 1)
  double softness = -100.0;  ///< alpha of the soft minimum, below 0
  double diversity = 1.0;    ///< lambda 1, of the similarity of shapelets, at least 0
  double regression = 1.0;   ///< lambda 2, of the error of the classifier, above 0
  double classifier = 1.0;   ///< lambda 3, of the size of the classifier, above 0
  int rounds = 50;           ///< rounds of the three updates at the most, at least 1
};

/// Learns on series of one length. Call the three updates in turn, any number of times.
///
/// The objective is, with X [K, N] the distances of equation 3, L_G the Laplacian of G_ij = exp(-|x_i - x_j|^2 /
/// sigma^2), H_ij = exp(-|s_i - s_j|^2 / sigma_H^2) for i != j:
///   1/2 tr(Y L_G Y^T) + lambda1/2 |H|^2 + lambda2/2 |W^T X - Y|^2 + lambda3/2 |W|^2,  Y Y^T = I.
/// Both widths are set at the start, by the median of the squared distances, and stay.
class UslmLearner {
 public:
  /// Starts with K = ShapeletCount() shapelets, K-means centroids of the windows of `series` [N, Q], and with the
  /// classifier and pseudo-labels at their optimum for these. \throws std::invalid_argument where an option is out of
  /// range, N <= `clusters`, or series of fewer than 2 values.
  UslmLearner(const Eigen::Ref<const Eigen::MatrixXd>& series, int clusters, const UslmOptions& options,
              std::uint64_t seed);

  /// Sets Y to the `clusters` eigenvectors of least eigenvalue of L_G + lambda2 (I - lambda2 X^T (lambda2 X X^T +
  /// lambda3 I)^-1 X): the best Y, where W follows it. So the objective falls once UpdateClassifier() has followed.
  void UpdatePseudoLabels();
  /// Sets W = (lambda2 X X^T + lambda3 I)^-1 lambda2 X Y^T, the best one for X and Y.
  void UpdateClassifier();
  /// Moves S along its negative gradient by a step that lowers the objective, found by halving (Armijo's rule); returns
  /// false where there is none.
  bool UpdateShapelets();
  /// The three updates until the objective falls by less than 1e-5 of itself, at most UslmOptions::rounds times.
  void Learn();

  /// The objective of the present S, W and Y.
  double Objective() const;
  /// Its gradient over S [K, M], W and Y held.
  Eigen::MatrixXd ShapeletGradient() const;

  const Eigen::MatrixXd& shapelets() const { return shapelets_; }          ///< S [K, M]
  const Eigen::MatrixXd& classifier() const { return classifier_; }        ///< W [K, C]
  const Eigen::MatrixXd& pseudo_labels() const { return pseudo_labels_; }  ///< Y [C, N]
  /// Replaces S, all else held. \throws std::invalid_argument where its size differs.
  void set_shapelets(const Eigen::Ref<const Eigen::MatrixXd>& shapelets);
  /// Replaces W, all else held. \throws std::invalid_argument where its size differs.
  void set_classifier(const Eigen::Ref<const Eigen::MatrixXd>& classifier);

 private:
  double ObjectiveAt(const Eigen::MatrixXd& shapelets, const Eigen::MatrixXd& distances) const;
  Eigen::MatrixXd ShapeletSimilarity(const Eigen::MatrixXd& shapelets) const;

  UslmOptions options_;
  int clusters_;
  Eigen::MatrixXd series_;
  double graph_width_ = 1.0;
  double diversity_width_ = 1.0;
  double step_ = 1.0;
  Eigen::MatrixXd shapelets_;
  Eigen::MatrixXd distances_;
  Eigen::MatrixXd classifier_;
  Eigen::MatrixXd pseudo_labels_;
};

/// X [K, N] of equation 3: the soft minimum over the windows of series j (`series` [N, Q]) of the mean squared
/// difference to shapelet i (`shapelets` [K, M]), sum d exp(alpha d) / sum exp(alpha d), alpha = `softness` < 0.
Eigen::MatrixXd SoftMinimumDistances(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                     const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness);

/// K-means on the distances to the shapelets of USLM.
class UslmClusterer : public FeatureClusterer {
 public:
  /// \param options see there
  explicit UslmClusterer(const UslmOptions& options) : options_(options) {}
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;

 private:
  UslmOptions options_;
  int length_ = 0;
  Eigen::MatrixXd shapelets_;
};

}  // namespace contact_shapelets::evaluation
