#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/change_points/subsequences.h"

/// \file
/// The nearest neighbours of subsequences, and what they vote for.

namespace contact_shapelets::core {

/// The most neighbours a subsequence can have.
constexpr int kMostNeighbours = 15;

/// The `neighbours` most similar subsequences of each subsequence among those that were offered.
class NeighbourTable {
 public:
  /// No rows yet, each to have `neighbours` in 1 ... kMostNeighbours.
  explicit NeighbourTable(int neighbours) : neighbours_(neighbours) {}

  /// Appends a subsequence without neighbours.
  void AppendRow();
  /// Forgets the first `count` subsequences; indices of neighbours count from the first that remains, so that those of
  /// forgotten ones are negative.
  void EraseFirst(int count);
  /// Makes subsequence j a neighbour of subsequence i if it is more similar than one of those that i has. Of equals,
  /// the first one stays.
  void Offer(int i, double correlation, int j) {
    if (correlation > weakest_[i]) Insert(i, correlation, j);
  }

  /// Offers subsequence i to j, j + 1, ..., j + kLanes - 1, and each of these to i.
  void OfferLanes(int i, int j, const Lanes& correlations) {
    // One look at all lanes, since hardly any pair changes anything.
    const Eigen::Map<const Lanes> theirs(weakest_.data() + j);
    if ((correlations - theirs.min(weakest_[i])).maxCoeff() <= 0.0) return;
    for (int lane = 0; lane < kLanes; ++lane) OfferPair(i, j + lane, correlations[lane]);
  }
  /// Offers subsequences i and j to one another.
  void OfferPair(int i, int j, double correlation) {
    Offer(i, correlation, j);
    Offer(j, correlation, i);
  }

  /// How many subsequences there are.
  int size() const { return static_cast<int>(weakest_.size()); }
  /// The neighbours of subsequence i, the most similar first; -1 where it has fewer.
  std::vector<int> Neighbours(int i) const;
  /// The correlations of subsequence i with its neighbours.
  std::vector<double> Correlations(int i) const;

  /// What the neighbours of the subsequences from `oldest` on vote for, by subsequence: the index from `oldest` on that
  /// a split must be above so that most of the subsequence's neighbours lie left of it; -1 where it has none.
  /// Neighbours before `oldest` have no vote, and of an even number the least similar has none.
  std::vector<int> Votes(int oldest) const;

 private:
  void Insert(int i, double correlation, int j);

  int neighbours_;
  std::vector<double> correlations_;  ///< of each subsequence, in descending order
  std::vector<int> indices_;
  std::vector<double> weakest_;  ///< correlation that a new neighbour must exceed
};

}  // namespace contact_shapelets::core
