#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

/// \file
/// How well nearest neighbours tell the two sides of a split apart.

namespace contact_shapelets::core {

/// Subsequences by the side of a split on which they lie, and by that which their neighbours vote for.
struct SplitCounts {
  double left_as_left = 0.0;
  double left_as_right = 0.0;
  double right_as_left = 0.0;
  double right_as_right = 0.0;
};

/// The mean in [0, 1] of the F1 scores of both sides; 0 for a side to which no subsequence belongs and for which none
/// votes.
double MacroF1(const SplitCounts& counts);

/// The p-value of the two-sided rank-sum test (Wilcoxon 1945, normal approximation without correction for ties, as
/// ClaSP and ClaSS use it) that the votes of both sides come from one distribution. 1 where they vote against their own
/// side, and where one side is empty.
double RankSumPValue(const SplitCounts& counts);

/// A split of a series, and how good it is.
struct Split {
  int index;       ///< first sample of the right side
  double score;    ///< MacroF1()
  double p_value;  ///< RankSumPValue()
};

/// The classification score profile of a series: the score of every split of it, by cross-validation of the nearest
/// neighbours' votes (Schäfer, Ermshaus, Leser: ClaSP - Time Series Segmentation, CIKM 2021).
///
/// A vote changes once, where the split passes the neighbour in the middle. So all splits are scored by four running
/// counts, in O(n) time.
class ClassificationProfile {
 public:
  /// `votes` are those of NeighbourTable::Votes(), of subsequences of `window` samples.
  ClassificationProfile(const std::vector<int>& votes, int window);

  /// Subsequences, and their votes, by side of the split before sample `split`, in 0 ... number of subsequences. Those
  /// that hold samples of both sides are left out.
  SplitCounts Counts(int split) const;

  /// The split with the highest score among those that leave at least `margin` samples on either side, `margin` at
  /// least the window; the first of equals. None where the series is too short.
  std::optional<Split> Best(int margin) const;

 private:
  /// Of the subsequences that have a vote, how many ...
  struct Running {
    int left = 0;            ///< begin left of the split
    int voting_left = 0;     ///< vote for left
    int agreeing = 0;        ///< begin left and vote for left
    int agreeing_whole = 0;  ///< lie wholly left and vote for left
  };

  int subsequences_;
  int window_;
  std::vector<Running> running_;  ///< of the split before each sample
};

}  // namespace contact_shapelets::core
