#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "contact_shapelets/core/ncc.h"

namespace contact_shapelets::core {
namespace {

/// CC_w of one window in double precision.
double Evaluate(const WindowSet& windows, const float* shapelet, int window, int shift) {
  const int length = windows.length();
  const float* series = windows.series().data() + window;
  const double mean = windows.mean()[window];
  double sum = 0.0;
  for (int m = std::max(0, -shift); m < std::min(length, length - shift); ++m) {
    sum += static_cast<double>(shapelet[m]) * (static_cast<double>(series[m + shift]) - mean);
  }
  return sum * windows.inverse_deviation()[window] / length;
}

}  // namespace

void FindBestMatches(const WindowSet& windows, const ShapeletSet& shapelets, const std::vector<Match>& hints,
                     const MatchOptions& options, std::vector<Match>* matches) {
  const int length = windows.length();
  if (length != shapelets.length()) throw std::invalid_argument("windows and shapelets differ in length");
  const int count = static_cast<int>(windows.series().size());
  const int window_count = windows.window_count();
  (void)hints;
  (void)options;
  const double centre = windows.series().cast<double>().mean();
  std::vector<float> series(count + length, 0.0F);
  for (int p = 0; p < count; ++p) series[p] = static_cast<float>(windows.series()[p] - centre);
  const Eigen::VectorXf scale = (windows.inverse_deviation() / length).cast<float>();
  const Eigen::VectorXf offset =
      ((windows.mean().array() - centre) * windows.inverse_deviation().array() / length).cast<float>().matrix();
  matches->assign(shapelets.count(), Match{});
  std::vector<float> sums(count);
  std::vector<float> best(count);
  std::vector<int> best_overlap(count);
  for (int k = 0; k < shapelets.count(); ++k) {
    const float* s = shapelets.normalised().col(k).data();
    Match& match = (*matches)[k];
    float least = -2.0F;
    int window = -1;
    int shift = 0;
    const auto offer = [&](float value, int j, int w) {
      if (value > least && !windows.IsFlat(j)) {
        least = value;
        window = j;
        shift = w;
      }
    };
    std::fill(sums.begin(), sums.end(), 0.0F);
    float total = 0.0F;
    for (int m = 0; m < length; ++m) {  // overlaps L = m + 1 of prefixes; w = length - L
      total += s[m];
      for (int p = 0; p < count - m; ++p) sums[p] += s[m] * series[p + m];
      const int overlap = m + 1;
      float most = least;
      for (int j = 0; j < window_count; ++j) {
        const float value = sums[j + length - overlap] * scale[j] - total * offset[j];
        most = std::max(most, value);
      }
      if (most > least) {
        for (int j = 0; j < window_count; ++j) {
          offer(sums[j + length - overlap] * scale[j] - total * offset[j], j, length - overlap);
        }
      }
    }
    std::fill(sums.begin(), sums.end(), 0.0F);
    total = 0.0F;
    for (int overlap = 1; overlap < length; ++overlap) {  // suffixes; sums by the end of the overlap
      const int m = length - overlap;
      total += s[m];
      for (int end = overlap - 1; end < count; ++end) sums[end] += s[m] * series[end - overlap + 1];
      float most = least;
      for (int j = 0; j < window_count; ++j) {
        most = std::max(most, sums[j + overlap - 1] * scale[j] - total * offset[j]);
      }
      if (most > least) {
        for (int j = 0; j < window_count; ++j) offer(sums[j + overlap - 1] * scale[j] - total * offset[j], j, -m);
      }
    }
    if (window >= 0) {
      match.window = window;
      match.shift = shift;
      match.similarity = static_cast<float>(Evaluate(windows, s, window, shift));
    }
  }
}

const char* KernelInstructionSet() { return "portable"; }

}  // namespace contact_shapelets::core
