#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// USLM: Zhang, Wu, Yang, Tian, Zhang: Unsupervised Feature Learning from Time Series, IJCAI 2016 (also USSL, TPAMI
/// 2019). It learns shapelets, pseudo-labels and a linear classifier between them in turn.

namespace contact_shapelets::evaluation {

/// Parameters of UslmLearner.
struct UslmOptions {
  double scale = 0.2;        ///< length of the shapelets as a part of the series, (0, 1)
  double softness = -100.0;  ///< alpha of the soft minimum, below 0
  double diversity = 1.0;    ///< lambda1, weight of the similarity of shapelets, at least 0
  double regression = 1.0;   ///< lambda2, weight of the error of the classifier, above 0
  double classifier = 1.0;   ///< lambda3, weight of the size of the classifier, above 0
  int rounds = 50;           ///< greatest number of rounds of the three updates, at least 1
};

/// Learns on series of one length. Call the three updates in turn, any number of times.
///
/// They minimise, under Y Y^T = I,
///   1/2 tr(Y L_G Y^T) + lambda1/2 |H|^2 + lambda2/2 |W^T X - Y|^2 + lambda3/2 |W|^2.
/// X [K, N] are the distances of equation 3, L_G is the Laplacian of G_ij = exp(-|x_i - x_j|^2 / sigma^2), and
/// H_ij = exp(-|s_i - s_j|^2 / sigma_H^2) for i != j. The start sets sigma^2 and sigma_H^2 to the median of the squared
/// distances; they stay as they are.
class UslmLearner {
 public:
  /// Starts with K = ShapeletCount() shapelets, which are K-means centroids of the windows of `series` [N, Q], and with
  /// the best pseudo-labels and classifier for these. \throws std::invalid_argument if an option is out of range,
  /// N <= `clusters`, or Q < 2.
  UslmLearner(const Eigen::Ref<const Eigen::MatrixXd>& series, int clusters, const UslmOptions& options,
              std::uint64_t seed);

  /// Sets Y to the eigenvectors of the `clusters` least eigenvalues of
  /// L_G + lambda2 (I - lambda2 X^T (lambda2 X X^T + lambda3 I)^-1 X). That is the best Y if W follows it, so the
  /// objective falls only when UpdateClassifier() has followed.
  void UpdatePseudoLabels();
  /// Sets W = (lambda2 X X^T + lambda3 I)^-1 lambda2 X Y^T, the best one for X and Y.
  void UpdateClassifier();
  /// Moves S along its negative gradient. Halves the step until it lowers the objective (Armijo's rule); returns false
  /// if no step does.
  bool UpdateShapelets();
  /// Repeats the three updates until the objective falls by less than 1e-5 of itself, at most UslmOptions::rounds
  /// times.
  void Learn();

  /// Returns the objective of the present S, W and Y.
  double Objective() const;
  /// Returns its gradient by S [K, M]; W and Y stay fixed.
  Eigen::MatrixXd ShapeletGradient() const;

  const Eigen::MatrixXd& shapelets() const { return shapelets_; }          ///< S [K, M]
  const Eigen::MatrixXd& classifier() const { return classifier_; }        ///< W [K, C]
  const Eigen::MatrixXd& pseudo_labels() const { return pseudo_labels_; }  ///< Y [C, N]
  /// Replaces S, and X by the distances to it. \throws std::invalid_argument if its size differs.
  void set_shapelets(const Eigen::Ref<const Eigen::MatrixXd>& shapelets);
  /// Replaces W. \throws std::invalid_argument if its size differs.
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

/// Returns X [K, N] of equation 3: X_ij = sum d exp(alpha d) / sum exp(alpha d), a soft minimum over the windows of
/// series j. d is the mean squared difference between a window and shapelet i. `series` are [N, Q], `shapelets` [K, M],
/// one per row; alpha = `softness` < 0.
Eigen::MatrixXd SoftMinimumDistances(const Eigen::Ref<const Eigen::MatrixXd>& series,
                                     const Eigen::Ref<const Eigen::MatrixXd>& shapelets, double softness);

/// K-means on the distances to the shapelets of USLM.
class UslmClusterer : public FeatureClusterer {
 public:
  /// Learns shapelets by `options`.
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
