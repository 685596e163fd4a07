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
/// A row holds a class, which is a number, and the values of one series, separated by tabs, commas or spaces. NaN at
/// the end of a row pads a shorter series and is left out. NaN elsewhere is a missing value; it is interpolated
/// linearly, or takes the first value if it is at the start, as in the archive's own adjusted version. If a class has a
/// single member in one of the files only, the reader adds a line about it to `notes` (may be null).
///
/// \throws std::runtime_error in one line that names file and row, if a file is missing or empty, rows differ in width,
///   a value is not a number or is infinite, a series has fewer than 2 values or is constant, a class has no second
///   member in either file, there are fewer than 2 classes, or fewer series than classes.
DataSet ReadUcrDataSet(const std::string& folder, const std::string& name, std::vector<std::string>* notes);

/// Returns the names of the data sets in `folder`, in alphabetical order. \throws std::runtime_error if it is not a
/// folder or holds no data set.
std::vector<std::string> UcrDataSetNames(const std::string& folder);

}  // namespace contact_shapelets::evaluation
