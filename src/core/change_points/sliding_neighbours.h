#pragma once

#include <vector>

#include "core/change_points/neighbour_table.h"
#include "core/change_points/subsequences.h"

/// \file
/// Nearest neighbours of the subsequences of a stream.

namespace contact_shapelets::core {

/// Keeps the nearest neighbours among the subsequences of a sliding window over a stream: each new sample ends one new
/// subsequence, which is compared with all others (Ermshaus et al.: Raising the ClaSS of streaming time series
/// segmentation, VLDB 2023), in O(sliding window) time and memory.
///
/// Neighbours that leave the sliding window, or are forgotten, lose their vote; no others take their place.
class SlidingNeighbours {
 public:
  /// Subsequences of `window` samples with `neighbours` each, within `sliding_window` samples, at least 2 windows.
  SlidingNeighbours(int window, int neighbours, int sliding_window);

  /// Takes the next sample.
  void Append(double sample);
  /// Forgets the first `count` samples.
  void Forget(int count) { first_ += count; }

  /// Samples that are not forgotten.
  int size() const;
  /// What the neighbours of the subsequences of these vote for; see NeighbourTable::Votes() and
  /// CorrectVotesOfFlatOnes().
  std::vector<int> Votes() const;
  /// The neighbours of these, by index of the subsequence; those that are forgotten, or missing, are negative.
  std::vector<std::vector<int>> Neighbours() const;

 private:
  void AppendSubsequence();
  void EraseForgotten();

  int sliding_window_;
  int samples_ = 0;  ///< in memory
  int first_ = 0;    ///< sample in memory that is not forgotten
  Subsequences subsequences_;
  NeighbourTable table_;
  /// Covariances of the newest subsequence with those before, the longest lag that can be first. Each lag is computed
  /// anew once in a while, so that no rounding stays.
  std::vector<double> covariances_;
  int renewed_lag_ = 0;
};

}  // namespace contact_shapelets::core
