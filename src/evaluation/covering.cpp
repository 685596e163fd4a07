#include "evaluation/covering.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace contact_shapelets::evaluation {
namespace {

/// 0, the change points in order, and the length.
std::vector<std::int64_t> Borders(const std::vector<std::int64_t>& change_points, std::int64_t length) {
  std::vector<std::int64_t> borders = {0, length};
  for (const std::int64_t change_point : change_points) {
    if (change_point <= 0 || change_point >= length) {
      throw std::invalid_argument("change point " + std::to_string(change_point) + " is not within a series of " +
                                  std::to_string(length) + " samples");
    }
    borders.push_back(change_point);
  }
  std::sort(borders.begin(), borders.end());
  return borders;
}

double IntersectionOverUnion(std::int64_t begin, std::int64_t end, std::int64_t other_begin, std::int64_t other_end) {
  const std::int64_t intersection = std::min(end, other_end) - std::max(begin, other_begin);
  if (intersection <= 0) return 0.0;
  const std::int64_t both = (end - begin) + (other_end - other_begin);
  return static_cast<double>(intersection) / static_cast<double>(both - intersection);
}

}  // namespace

double Covering(const std::vector<std::int64_t>& true_change_points,
                const std::vector<std::int64_t>& found_change_points, std::int64_t length) {
  if (length < 1) throw std::invalid_argument("the covering needs a series of at least 1 sample");
  const std::vector<std::int64_t> truth = Borders(true_change_points, length);
  const std::vector<std::int64_t> found = Borders(found_change_points, length);
  double sum = 0.0;
  for (std::size_t segment = 0; segment + 1 < truth.size(); ++segment) {
    double best = 0.0;
    for (std::size_t other = 0; other + 1 < found.size(); ++other) {
      best = std::max(best, IntersectionOverUnion(truth[segment], truth[segment + 1], found[other], found[other + 1]));
    }
    sum += best * static_cast<double>(truth[segment + 1] - truth[segment]);
  }
  return sum / static_cast<double>(length);
}

}  // namespace contact_shapelets::evaluation
