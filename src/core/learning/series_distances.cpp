#include "core/learning/series_distances.h"

#include <numeric>

#include "core/learning/objective.h"
#include "core/numerics/series.h"

namespace contact_shapelets::core {

SeriesDistances::SeriesDistances(const std::vector<Eigen::VectorXf>& series, int length)
    : series_(series), length_(length) {
  if (series.size() > kMostInTable) return;
  std::vector<int> all(series.size());
  std::iota(all.begin(), all.end(), 0);
  table_ = Compute(all);
}

Eigen::MatrixXd SeriesDistances::Among(const std::vector<int>& chosen) const {
  if (table_.size() == 0) return Compute(chosen);
  const auto count = static_cast<Eigen::Index>(chosen.size());
  return Eigen::MatrixXd::NullaryExpr(count, count, [&](Eigen::Index row, Eigen::Index column) {
    return table_(chosen[static_cast<std::size_t>(row)], chosen[static_cast<std::size_t>(column)]);
  });
}

Eigen::MatrixXd SeriesDistances::Compute(const std::vector<int>& chosen) const {
  Eigen::MatrixXf stretched(chosen.size(), length_);
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    const auto index = static_cast<std::size_t>(chosen[row]);
    stretched.row(static_cast<Eigen::Index>(row)) = StretchedTo(series_[index], length_).transpose();
  }
  return SquaredDistances(stretched);
}

}  // namespace contact_shapelets::core
