#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// \file
/// Series with known classes in two splits: one to learn from, one to test on.

namespace contact_shapelets::evaluation {

/// Series with their classes.
struct LabelledSeries {
  std::vector<Eigen::VectorXf> series;  ///< N series, which may differ in length
  Eigen::VectorXi classes;              ///< [N], 0 to the number of classes - 1
};

/// A data set with its two splits.
struct DataSet {
  std::string name;
  LabelledSeries train;
  LabelledSeries test;
  int class_count = 0;  ///< number of classes C in both splits; methods know nothing else about the classes
};

/// Returns the series as rows [N, length]: stretched to `length` values by linear interpolation, then z-normalised.
/// \throws std::invalid_argument if there is no series or `length` < 2.
Eigen::MatrixXf EqualLengthRows(const std::vector<Eigen::VectorXf>& series, int length);

}  // namespace contact_shapelets::evaluation
