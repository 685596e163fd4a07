#include "core/change_points/window_size.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace contact_shapelets::core {
namespace {

/// How much of the statistics of the whole series a window must show.
constexpr double kEnough = 0.89;

/// The extreme of the last `window` values, from one value to the next.
template <typename IsBetter>
class MovingExtreme {
 public:
  MovingExtreme(const Eigen::VectorXd& series, int window)
      : series_(series), window_(window), candidates_(window + 1) {}

  /// Takes the value at `index`, the next one. Returns the extreme of the window that ends with it.
  double Add(int index) {
    // Candidates are in a ring, the present extreme first, each better than all that follow it in the series.
    while (count_ > 0 && !IsBetter()(series_[At(count_ - 1)], series_[index])) --count_;
    At(count_++) = index;
    if (At(0) <= index - window_) {
      first_ = (first_ + 1) % static_cast<int>(candidates_.size());
      --count_;
    }
    return series_[At(0)];
  }

 private:
  int& At(int place) { return candidates_[(first_ + place) % candidates_.size()]; }

  const Eigen::VectorXd& series_;
  int window_;
  std::vector<int> candidates_;
  int first_ = 0;
  int count_ = 0;
};

/// Statistics of windows against those of the whole series, whose range is 1.
class SummaryStatistics {
 public:
  /// `series` lies in [0, 1], touches both, and outlives this object.
  explicit SummaryStatistics(const Eigen::VectorXd& series)
      : series_(series),
        mean_(series.mean()),
        deviation_(std::sqrt((series.array() - mean_).square().mean())),
        sums_(series.size() + 1),
        squares_(series.size() + 1) {
    sums_[0] = squares_[0] = 0.0;
    for (int index = 0; index < series.size(); ++index) {
      sums_[index + 1] = sums_[index] + series[index];
      squares_[index + 1] = squares_[index] + series[index] * series[index];
    }
  }

  /// The mean distance of the windows' statistics from those of the series, over the root of the window size.
  double Distance(int window) const {
    MovingExtreme<std::less<>> least(series_, window);
    MovingExtreme<std::greater<>> most(series_, window);
    const int size = static_cast<int>(series_.size());
    double sum = 0.0;
    for (int index = 0; index < size; ++index) {
      const double range = -least.Add(index) + most.Add(index);
      const int begin = index + 1 - window;
      if (begin < 0) continue;
      const double mean = (sums_[index + 1] - sums_[begin]) / window;
      const double variance = (squares_[index + 1] - squares_[begin]) / window - mean * mean;
      const double deviation = std::sqrt(std::max(0.0, variance));
      sum += std::sqrt(std::pow(mean - mean_, 2) + std::pow(deviation - deviation_, 2) + std::pow(range - 1.0, 2));
    }
    return sum / (size - window + 1) / std::sqrt(window);
  }

 private:
  const Eigen::VectorXd& series_;
  double mean_;
  double deviation_;
  Eigen::VectorXd sums_;
  Eigen::VectorXd squares_;
};

}  // namespace

int SelectWindowSize(const Eigen::Ref<const Eigen::VectorXd>& series) {
  const int size = static_cast<int>(series.size());
  if (size < 2 * kShortestWindow) return kShortestWindow;
  const double least = series.minCoeff();
  const double range = series.maxCoeff() - least;
  if (range <= 0.0) return kShortestWindow;
  const Eigen::VectorXd scaled = (series.array() - least) / range;

  const SummaryStatistics statistics(scaled);
  const double farthest = statistics.Distance(1);
  const double nearest = statistics.Distance(size);
  const auto enough = [&](int window) {
    return farthest - statistics.Distance(window) >= kEnough * (farthest - nearest);
  };
  int longest = kShortestWindow;
  while (longest < size && !enough(longest)) longest = std::min(2 * longest, size);
  int window = std::max(kShortestWindow, longest / 2);
  while (window < longest) {
    const int middle = (window + longest) / 2;
    if (enough(middle)) {
      longest = middle;
    } else {
      window = middle + 1;
    }
  }
  return window;
}

}  // namespace contact_shapelets::core
