#pragma once

#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// Values that generate.py computed, independently of the C++ code.

namespace contact_shapelets::test {

/// The matrix of this name in test/golden/values.txt. \throws std::runtime_error if it is not there or incomplete.
inline Eigen::MatrixXd Golden(const std::string& name) {
  std::ifstream file("test/golden/values.txt");
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream head(line);
    std::string found;
    Eigen::Index rows = 0;
    Eigen::Index columns = 0;
    if (!(head >> found >> rows >> columns) || found != name) continue;
    Eigen::MatrixXd values(rows, columns);
    for (Eigen::Index row = 0; row < rows; ++row) {
      for (Eigen::Index column = 0; column < columns; ++column) file >> values(row, column);
    }
    if (file) return values;
  }
  throw std::runtime_error("test/golden/values.txt: expected a whole matrix " + name);
}

/// The only value of a matrix of one row and one column.
inline double GoldenNumber(const std::string& name) {
  const Eigen::MatrixXd values = Golden(name);
  if (values.size() != 1) throw std::runtime_error("test/golden/values.txt: expected one value at " + name);
  return values(0, 0);
}

/// The rows of a matrix, in single precision.
inline std::vector<Eigen::VectorXf> GoldenSeries(const std::string& name) {
  const Eigen::MatrixXd values = Golden(name);
  std::vector<Eigen::VectorXf> rows;
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    rows.emplace_back(values.row(row).transpose().cast<float>());
  }
  return rows;
}

/// The largest difference between values of two matrices of one shape; infinite if their shapes differ.
inline double LargestDifference(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second) {
  if (first.rows() != second.rows() || first.cols() != second.cols()) return HUGE_VAL;
  return (first - second).cwiseAbs().maxCoeff();
}

}  // namespace contact_shapelets::test
