#include "core/change_points/classification_profile.h"

#include <algorithm>
#include <cmath>

namespace contact_shapelets::core {

double MacroF1(const SplitCounts& counts) {
  const double wrong = counts.left_as_right + counts.right_as_left;
  const double left = 2.0 * counts.left_as_left + wrong;
  const double right = 2.0 * counts.right_as_right + wrong;
  return (left > 0.0 ? counts.left_as_left / left : 0.0) + (right > 0.0 ? counts.right_as_right / right : 0.0);
}

double RankSumPValue(const SplitCounts& counts) {
  const double left = counts.left_as_left + counts.left_as_right;
  const double right = counts.right_as_left + counts.right_as_right;
  // The rank sum of the left side less its expectation: with two values only, ranks are the same within each.
  const double surplus =
      0.5 * (counts.left_as_left * counts.right_as_right - counts.left_as_right * counts.right_as_left);
  if (left <= 0.0 || right <= 0.0 || surplus <= 0.0) return 1.0;
  const double variance = left * right * (left + right + 1.0) / 12.0;
  return std::erfc(surplus / std::sqrt(2.0 * variance));
}

ClassificationProfile::ClassificationProfile(const std::vector<int>& votes, int window)
    : subsequences_(static_cast<int>(votes.size())), window_(window), running_(votes.size() + 1) {
  // First how many subsequences a split gains when it moves by one sample, then the sums.
  for (int index = 0; index < subsequences_; ++index) {
    const int vote = votes[index];
    if (vote < 0) continue;
    ++running_[index + 1].left;
    ++running_[vote + 1].voting_left;
    ++running_[std::max(index, vote) + 1].agreeing;
    if (index + window_ <= subsequences_) ++running_[std::max(index + window_, vote + 1)].agreeing_whole;
  }
  for (int split = 1; split <= subsequences_; ++split) {
    Running& now = running_[split];
    const Running& before = running_[split - 1];
    now.left += before.left;
    now.voting_left += before.voting_left;
    now.agreeing += before.agreeing;
    now.agreeing_whole += before.agreeing_whole;
  }
}

SplitCounts ClassificationProfile::Counts(int split) const {
  const Running& now = running_[split];
  const int whole_left = split < window_ ? 0 : running_[split - window_ + 1].left;
  const int right = running_[subsequences_].left - now.left;
  const int right_as_left = now.voting_left - now.agreeing;
  SplitCounts counts;
  counts.left_as_left = now.agreeing_whole;
  counts.left_as_right = whole_left - now.agreeing_whole;
  counts.right_as_left = right_as_left;
  counts.right_as_right = right - right_as_left;
  return counts;
}

std::optional<Split> ClassificationProfile::Best(int margin) const {
  const int samples = subsequences_ + window_ - 1;
  std::optional<Split> best;
  for (int split = margin; split <= samples - margin; ++split) {
    const double score = MacroF1(Counts(split));
    if (!best || score > best->score) best = Split{split, score, 1.0};
  }
  if (best) best->p_value = RankSumPValue(Counts(best->index));
  return best;
}

}  // namespace contact_shapelets::core
