#include "core/change_points/neighbour_table.h"

#include <algorithm>
#include <array>

namespace contact_shapelets::core {
namespace {

/// Below any correlation, rounding included.
constexpr double kNoCorrelation = -2.0;

/// The one of an odd number of values with as many below as above. Reorders the values.
int Middle(int* values, int count) {
  if (count == 3) {
    // The usual number, without a branch that nothing predicts.
    return std::max(std::min(values[0], values[1]), std::min(std::max(values[0], values[1]), values[2]));
  }
  std::nth_element(values, values + count / 2, values + count);
  return values[count / 2];
}

}  // namespace

void NeighbourTable::AppendRow() {
  correlations_.insert(correlations_.end(), neighbours_, kNoCorrelation);
  indices_.insert(indices_.end(), neighbours_, -1);
  weakest_.push_back(kNoCorrelation);
}

void NeighbourTable::EraseFirst(int count) {
  correlations_.erase(correlations_.begin(), correlations_.begin() + count * neighbours_);
  indices_.erase(indices_.begin(), indices_.begin() + count * neighbours_);
  weakest_.erase(weakest_.begin(), weakest_.begin() + count);
  for (int& index : indices_) index -= count;
}

void NeighbourTable::Insert(int i, double correlation, int j) {
  double* const correlations = correlations_.data() + i * neighbours_;
  int* const indices = indices_.data() + i * neighbours_;
  int place = neighbours_ - 1;
  for (; place > 0 && correlation > correlations[place - 1]; --place) {
    correlations[place] = correlations[place - 1];
    indices[place] = indices[place - 1];
  }
  correlations[place] = correlation;
  indices[place] = j;
  weakest_[i] = correlations[neighbours_ - 1];
}

std::vector<int> NeighbourTable::Neighbours(int i) const {
  const auto first = indices_.begin() + i * neighbours_;
  return {first, first + neighbours_};
}

std::vector<double> NeighbourTable::Correlations(int i) const {
  const auto first = correlations_.begin() + i * neighbours_;
  return {first, first + neighbours_};
}

std::vector<int> NeighbourTable::Votes(int oldest) const {
  std::vector<int> votes(size() - oldest);
  std::array<int, kMostNeighbours> voters = {};
  for (int i = oldest; i < size(); ++i) {
    int count = 0;
    for (int place = i * neighbours_; place < (i + 1) * neighbours_; ++place) {
      voters[count] = indices_[place] - oldest;
      if (voters[count] >= 0) ++count;
    }
    votes[i - oldest] = count == 0 ? -1 : Middle(voters.data(), count % 2 == 0 ? count - 1 : count);
  }
  return votes;
}

}  // namespace contact_shapelets::core
