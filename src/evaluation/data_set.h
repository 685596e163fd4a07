#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// \file
/// Series with known classes, split into a part to learn from and a part to test on.

namespace contact_shapelets::evaluation {

/// Series with their classes.
struct LabelledSeries {
  std::vector<Eigen::VectorXf> series;  ///< N series, which may differ in length
  Eigen::VectorXi classes;              ///< [N], 0 to the number of classes less 1
};

/// One row of an evaluation.
struct DataSet {
  std::string name;
  LabelledSeries train;
  LabelledSeries test;
  int class_count = 0;  ///< C, over both splits; all that a method is told of the classes
};

/// The series as rows [N, length] of equal length: stretched by linear interpolation where theirs differs, and
/// z-normalised. \throws std::invalid_argument where there is no series or `length` < 2.
Eigen::MatrixXf EqualLengthRows(const std::vector<Eigen::VectorXf>& series, int length);

}  // namespace contact_shapelets::evaluation
