#include "core/change_points/nearest_neighbours.h"

#include <algorithm>

namespace contact_shapelets::core {

NeighbourTable FindNearestNeighbours(const Subsequences& subsequences, int first, int count, int neighbours) {
  NeighbourTable table(neighbours);
  for (int row = 0; row < count; ++row) table.AppendRow();
  // Diagonals of the matrix of all pairs, kLanes at a time, from the shortest lag to the longest.
  for (int lag = ExclusionZone(subsequences.window()); lag < count; lag += kLanes) {
    const int lanes = std::min(kLanes, count - lag);
    Lanes covariances = Lanes::Zero();
    for (int lane = 0; lane < lanes; ++lane) {
      covariances[lane] = subsequences.Covariance(first, first + lag + lane);
      table.OfferPair(0, lag + lane, subsequences.Correlation(first, first + lag + lane, covariances[lane]));
    }
    int row = 1;
    for (; row + lag + kLanes <= count; ++row) {
      const int i = first + row;
      covariances = subsequences.NextCovariances(i, i + lag, covariances);
      table.OfferLanes(row, row + lag, subsequences.Correlations(i, i + lag, covariances));
    }
    for (; row + lag < count; ++row) {
      const int i = first + row;
      for (int lane = 0; row + lag + lane < count; ++lane) {
        const int j = i + lag + lane;
        covariances[lane] = subsequences.NextCovariance(i, j, covariances[lane]);
        table.OfferPair(row, row + lag + lane, subsequences.Correlation(i, j, covariances[lane]));
      }
    }
  }
  return table;
}

void CorrectVotesOfFlatOnes(const Subsequences& subsequences, int first, std::vector<int>* votes) {
  std::vector<int> flat;
  for (int index = 0; index < static_cast<int>(votes->size()); ++index) {
    if (subsequences.IsFlat(first + index)) flat.push_back(index);
  }
  for (const int index : flat) (*votes)[index] = flat[flat.size() / 2];
}

}  // namespace contact_shapelets::core
