#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "evaluation/protocol.h"

namespace contact_shapelets::cli {

/// Writes `results` as Markdown tables: train, test by nearest centroid, test clustered anew, and the better mean of
/// the last two. Each table has a row per data set, a row of averages (blank if a data set is missing) and a column per
/// method. A cell has the mean ± standard deviation of the Rand index over seeds, then the best. Data sets and methods
/// keep their order.
void WriteMarkdown(const std::vector<evaluation::EvaluationResult>& results, const std::vector<std::string>& data_sets,
                   const std::vector<std::string>& methods, std::ostream* stream);

/// Writes `results` as a JSON list.
void WriteJson(const std::vector<evaluation::EvaluationResult>& results, std::ostream* stream);

}  // namespace contact_shapelets::cli
