#pragma once

#include <map>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"

/// \file
/// Figures and lists as people read them.

namespace contact_shapelets::cli {

/// `value` with this many `decimals`.
std::string Number(double value, int decimals);
/// `count` with its noun: "1 episode", "3 episodes".
std::string Count(std::size_t count, const std::string& noun);
/// `text` followed by spaces, so that it fills `width` characters.
std::string Padded(const std::string& text, std::size_t width);
/// `parts` with `separator` between them.
std::string Joined(const std::vector<std::string>& parts, const std::string& separator);
/// "4 broken, 2 switched"; empty where there is none.
std::string CountsText(const std::map<std::string, int>& counts);
/// The time on the clock of UTC: "2023-11-14 22:13:20".
std::string DateText(core::Nanoseconds time);
/// The last part of a path.
std::string FileName(const std::string& path);
/// The median (lower one of two) of `values`; 0 where there is none.
double Median(std::vector<double> values);
/// The outcomes of `episodes`, counted; those without one are left out.
std::map<std::string, int> CountOutcomes(const std::vector<core::Episode>& episodes);
/// The median duration of `episodes` in seconds.
double MedianDuration(const std::vector<core::Episode>& episodes);

}  // namespace contact_shapelets::cli
