#pragma once

#include <string>
#include <vector>

#include "evaluation/data_set.h"

/// \file
/// Reads data sets of the UCR time series archive (Dau et al., The UCR Time Series Archive, 2018).

namespace contact_shapelets::evaluation {

/// Reads the data set `name` of the archive in `folder`: `<folder>/<name>/<name>_TRAIN` and `_TEST`, or the same
/// without the folder `<name>`, each with the ending .tsv, .txt, .csv or none.
///
/// A row is a class, a number, and the values of one series, separated by tabs, commas or spaces. NaN at the end of a
/// row pads a shorter series and is left out; NaN elsewhere is a missing value, which is interpolated linearly (at the
/// start: takes the first value there is), as in the archive's own adjusted version. Where a class has a single member
/// in one of the files only, a line that says so is added to `notes` (may be null). \throws std::runtime_error in one
/// line that names file and row: no such file, empty, rows of different width, a value that
///   is not a number or is infinite, a series of fewer than 2 values, a constant series, a class without a second
///   member in either file, fewer than 2 classes, fewer series than classes.
DataSet ReadUcrDataSet(const std::string& folder, const std::string& name, std::vector<std::string>* notes);

/// Names of the data sets in `folder`, in alphabetical order. \throws std::runtime_error where it is not a folder or
/// holds no data set.
std::vector<std::string> UcrDataSetNames(const std::string& folder);

}  // namespace contact_shapelets::evaluation
