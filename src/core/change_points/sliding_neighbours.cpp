#include "core/change_points/sliding_neighbours.h"

#include <algorithm>

#include "core/change_points/nearest_neighbours.h"

namespace contact_shapelets::core {

SlidingNeighbours::SlidingNeighbours(int window, int neighbours, int sliding_window)
    : sliding_window_(sliding_window), subsequences_(window), table_(neighbours), covariances_(sliding_window, 0.0) {}

void SlidingNeighbours::Append(double sample) {
  subsequences_.Append(sample);
  ++samples_;
  first_ = std::max(first_, samples_ - sliding_window_);
  if (table_.size() < subsequences_.size()) AppendSubsequence();
  if (first_ >= sliding_window_) EraseForgotten();
}

void SlidingNeighbours::AppendSubsequence() {
  table_.AppendRow();
  const int newest = table_.size() - 1;
  const int longest = newest - first_;
  const int shortest = ExclusionZone(subsequences_.window());
  if (longest < shortest) return;
  const auto covariance = [&](int other) { return covariances_.data() + (sliding_window_ - 1 - newest + other); };
  int other = newest - shortest;
  for (; other - kLanes >= first_; other -= kLanes) {
    const int begin = other - kLanes + 1;
    Eigen::Map<Lanes> lanes(covariance(begin));
    lanes = subsequences_.NextCovariances(newest, begin, lanes);
    table_.OfferLanes(newest, begin, subsequences_.Correlations(newest, begin, lanes));
  }
  for (; other >= first_; --other) {
    // The longest lag has no predecessor while the memory grows.
    double& now = *covariance(other);
    now = other == first_ ? subsequences_.Covariance(newest, other) : subsequences_.NextCovariance(newest, other, now);
    table_.OfferPair(newest, other, subsequences_.Correlation(newest, other, now));
  }
  renewed_lag_ = renewed_lag_ <= shortest ? longest : std::min(renewed_lag_ - 1, longest);
  *covariance(newest - renewed_lag_) = subsequences_.Covariance(newest, newest - renewed_lag_);
}

void SlidingNeighbours::EraseForgotten() {
  subsequences_.EraseFirst(first_);
  table_.EraseFirst(first_);
  samples_ -= first_;
  first_ = 0;
}

int SlidingNeighbours::size() const { return samples_ - first_; }

std::vector<int> SlidingNeighbours::Votes() const {
  std::vector<int> votes = table_.Votes(first_);
  CorrectVotesOfFlatOnes(subsequences_, first_, &votes);
  return votes;
}

std::vector<std::vector<int>> SlidingNeighbours::Neighbours() const {
  std::vector<std::vector<int>> all;
  for (int i = first_; i < table_.size(); ++i) {
    all.push_back(table_.Neighbours(i));
    for (int& neighbour : all.back()) neighbour = std::max(-1, neighbour - first_);
  }
  return all;
}

}  // namespace contact_shapelets::core
