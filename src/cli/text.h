#pragma once

#include <map>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

/// \file
/// Figures and lists for people to read.

namespace contact_shapelets::cli {

/// Returns `value` with this number of `decimals`.
std::string Number(double value, int decimals);
/// Returns `count` with its noun: "1 episode", "3 episodes".
std::string Count(std::size_t count, const std::string& noun);
/// Returns `text` with spaces up to `width` characters.
std::string Padded(const std::string& text, std::size_t width);
/// Returns `parts` with `separator` between them.
std::string Joined(const std::vector<std::string>& parts, const std::string& separator);
/// Returns "4 broken, 2 switched"; an empty string if there are no counts.
std::string CountsText(const std::map<std::string, int>& counts);
/// Returns `text` as a field of a comma-separated table: with quotes if it holds a comma, a quote or a line break.
std::string CsvField(const std::string& text);
/// Returns the time in UTC: "2023-11-14 22:13:20".
std::string DateText(core::Nanoseconds time);
/// Returns the one of `words` that `word` is most likely a misspelling of, at most two letters changed, left out, added
/// or swapped; an empty string if there is none.
std::string Likely(const std::string& word, const std::vector<std::string>& words);
/// Returns the last part of a path.
std::string FileName(const std::string& path);
/// Returns the median (the lower of two) of `values`; 0 if there are none.
double Median(std::vector<double> values);
/// Counts the outcomes of `episodes`. Ignores episodes without one.
std::map<std::string, int> CountOutcomes(const std::vector<core::Episode>& episodes);
/// Returns the median duration of `episodes` in seconds.
double MedianDuration(const std::vector<core::Episode>& episodes);

}  // namespace contact_shapelets::cli
