#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "evaluation/feature_clusterer.h"

/// \file
/// A shapelet dictionary by sparse coding, after Zhang et al. (CASE 2019): a shapelet is an atom, and each
/// subsequence is a sum of few atoms. Dictionary and codes are learned in turn: orthogonal matching pursuit (Pati et
/// al. 1993) and the approximate K-SVD update (Rubinstein et al. 2008).

namespace contact_shapelets::evaluation {

/// Parameters of LearnDictionary() and DictionaryClusterer.
struct DictionaryOptions {
  double scale = 0.2;  ///< length of the atoms as a part of the series', (0, 1)
  int sparsity = 2;    ///< atoms in the code of one subsequence at most, at least 1
  int rounds = 20;     ///< of coding and updating, at least 1
  int windows = 3000;  ///< subsequences that the dictionary is learned from at most, at least 2
};

/// The code [K] of `window` [M] in `atoms` [M, K], unit columns, with at most `sparsity` values that are not zero:
/// orthogonal matching pursuit. It stops early once the rest is zero.
Eigen::VectorXd SparseCode(const Eigen::Ref<const Eigen::MatrixXd>& atoms,
                           const Eigen::Ref<const Eigen::VectorXd>& window, int sparsity);

/// What LearnDictionary() found.
struct Dictionary {
  Eigen::MatrixXd atoms;       ///< [M, K], unit columns
  std::vector<double> errors;  ///< mean squared error of the codes in each round, before its update
};

/// Learns `count` atoms for `windows` [M, N], one per column. It starts from random windows; an atom that no window
/// uses takes the window with the greatest error. \throws std::invalid_argument if there are fewer windows than atoms,
/// or an
///   option is out of range.
Dictionary LearnDictionary(const Eigen::Ref<const Eigen::MatrixXd>& windows, int count,
                           const DictionaryOptions& options, std::uint64_t seed);

/// K-means on how strongly each atom occurs in a series: the greatest absolute coefficient over its subsequences.
class DictionaryClusterer : public FeatureClusterer {
 public:
  /// \param options see there
  explicit DictionaryClusterer(const DictionaryOptions& options) : options_(options) {}
  Eigen::MatrixXf Transform(const std::vector<Eigen::VectorXf>& series) const override;

 protected:
  void Learn(const std::vector<Eigen::VectorXf>& train, int clusters, std::uint64_t seed) override;

 private:
  DictionaryOptions options_;
  int length_ = 0;
  Eigen::MatrixXd atoms_;
};

}  // namespace contact_shapelets::evaluation
