#include "core/learning/shapelet_start.h"

#include <algorithm>
#include <utility>

#include "core/clustering/kmeans.h"
#include "core/numerics/random.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {
namespace {

struct WindowPlace {
  int series;
  int start;
};

bool IsFlat(const Eigen::Ref<const Eigen::VectorXf>& window, double flat_fraction) {
  return StandardDeviation(window) <= std::max(flat_fraction, 1e-6);
}

}  // namespace

Eigen::MatrixXf StartShapelets(const std::vector<Eigen::VectorXf>& series, int length, int count, double flat_fraction,
                               int most_windows, std::uint64_t seed) {
  const int stride = std::max(1, length / 8);
  std::vector<WindowPlace> places;
  for (int index = 0; index < static_cast<int>(series.size()); ++index) {
    const int last = std::max(0, static_cast<int>(series[index].size()) - length);
    for (int start = 0; start <= last; start += stride) places.push_back({index, start});
  }

  // Draws windows in random order until there are enough, so that the time does not grow with the number of series.
  Random random(StreamSeed(seed, 0));
  const auto total = static_cast<int>(places.size());
  Eigen::MatrixXf windows(std::min(most_windows, total), length);
  int taken = 0;
  for (int drawn = 0; drawn < total && taken < windows.rows(); ++drawn) {
    std::swap(places[drawn], places[drawn + random.Index(total - drawn)]);
    const WindowPlace place = places[drawn];
    const Eigen::VectorXf extended =
        ExtendedTo(series[place.series].segment(
                       place.start, std::min<Eigen::Index>(length, series[place.series].size() - place.start)),
                   length);
    if (!IsFlat(extended, flat_fraction)) windows.row(taken++) = ZNormalised(extended).transpose();
  }
  if (taken < 2 * count) return Eigen::MatrixXf(0, length);

  KMeansOptions options;
  options.clusters = count;
  options.restarts = 2;
  options.iterations = 30;
  options.seed = StreamSeed(seed, 1);
  return KMeans(windows.topRows(taken), options).centroids;
}

}  // namespace contact_shapelets::core
