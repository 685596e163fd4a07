#include "core/matching/ncc_definition.h"

#include <algorithm>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

/// CC_w of equation 2, term by term.
double CrossCorrelation(const float* shapelet, const double* window, int length, int shift) {
  double sum = 0.0;
  for (int m = std::max(0, -shift); m < std::min(length, length - shift); ++m) {
    sum += static_cast<double>(shapelet[m]) * window[m + shift];
  }
  return sum / length;
}

}  // namespace

std::vector<Match> BestMatchesByDefinition(const WindowSet& windows, const ShapeletSet& shapelets) {
  const int length = windows.length();
  if (length != shapelets.length()) throw std::invalid_argument("windows and shapelets differ in length");
  std::vector<Match> matches(static_cast<std::size_t>(shapelets.count()));
  std::vector<double> best(matches.size(), -2.0);
  const auto constant = [&shapelets](std::size_t k) {
    return shapelets.normalised().col(static_cast<Eigen::Index>(k)).isZero(0.0F);
  };
  for (int window = 0; window < windows.window_count(); ++window) {
    if (windows.IsFlat(window)) continue;
    const Eigen::VectorXd values =
        (windows.series().segment(window, length).cast<double>().array() - windows.mean()[window]) *
        windows.inverse_deviation()[window];
    for (std::size_t k = 0; k < matches.size(); ++k) {
      if (constant(k)) continue;
      const float* shapelet = shapelets.normalised().col(static_cast<Eigen::Index>(k)).data();
      for (int shift = 1 - length; shift < length; ++shift) {
        const double value = CrossCorrelation(shapelet, values.data(), length, shift);
        if (value <= best[k]) continue;
        best[k] = value;
        matches[k] = {static_cast<float>(value), window, shift};
      }
    }
  }
  return matches;
}

}  // namespace contact_shapelets::core
