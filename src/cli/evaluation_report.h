#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "evaluation/protocol.h"

namespace contact_shapelets::cli {

/// Writes `results` as Markdown tables, one for each of train, test by nearest centroid, test clustered anew, and the
/// better mean of the last two: a row per data set and one of averages (blank where a data set is missing), a column
/// per method; a cell is the Rand index's mean ± standard deviation over seeds, then the best. Data sets and methods
/// are in the order given.
void WriteMarkdown(const std::vector<evaluation::EvaluationResult>& results, const std::vector<std::string>& data_sets,
                   const std::vector<std::string>& methods, std::ostream* stream);

/// Writes `results` as a JSON list.
void WriteJson(const std::vector<evaluation::EvaluationResult>& results, std::ostream* stream);

}  // namespace contact_shapelets::cli
