#include "evaluation/data_set.h"

#include <stdexcept>

#include "core/numerics/series.h"

namespace contact_shapelets::evaluation {

Eigen::MatrixXf EqualLengthRows(const std::vector<Eigen::VectorXf>& series, int length) {
  if (series.empty()) throw std::invalid_argument("there is no series");
  if (length < 2) throw std::invalid_argument("series must have at least 2 values");
  Eigen::MatrixXf rows(series.size(), length);
  for (std::size_t index = 0; index < series.size(); ++index) {
    rows.row(static_cast<Eigen::Index>(index)) =
        core::ZNormalised(core::StretchedTo(series[index], length)).transpose();
  }
  return rows;
}

}  // namespace contact_shapelets::evaluation
