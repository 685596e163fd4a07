#include "cli/text.h"

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::cli {

namespace {

/// Returns the number of letters to change, leave out, add or swap with the next (Damerau 1964).
std::size_t Edits(const std::string& first, const std::string& second) {
  std::vector<std::vector<std::size_t>> edits(first.size() + 1, std::vector<std::size_t>(second.size() + 1));
  for (std::size_t i = 0; i <= first.size(); ++i) {
    for (std::size_t j = 0; j <= second.size(); ++j) {
      std::size_t& least = edits[i][j];
      least = std::max(i, j);
      if (i == 0 || j == 0) continue;
      const std::size_t change = first[i - 1] == second[j - 1] ? 0 : 1;
      least = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, edits[i - 1][j - 1] + change});
      const bool swapped = i > 1 && j > 1 && first[i - 1] == second[j - 2] && first[i - 2] == second[j - 1];
      if (swapped) least = std::min(least, edits[i - 2][j - 2] + 1);
    }
  }
  return edits[first.size()][second.size()];
}

}  // namespace

std::string Number(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string Count(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string Padded(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

std::string Joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string joined;
  for (const std::string& part : parts) joined += (joined.empty() ? "" : separator) + part;
  return joined;
}

std::string CountsText(const std::map<std::string, int>& counts) {
  std::vector<std::string> parts;
  for (const auto& [name, count] : counts) parts.push_back(std::to_string(count) + " " + name);
  return Joined(parts, ", ");
}

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::string DateText(core::Nanoseconds time) {
  const std::time_t seconds = static_cast<std::time_t>(time / 1'000'000'000);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d %H:%M:%S");
  return text.str();
}

std::string Likely(const std::string& word, const std::vector<std::string>& words) {
  std::size_t least = std::min<std::size_t>(3, word.size());
  std::string likely;
  for (const std::string& other : words) {
    const std::size_t edits = Edits(word, other);
    if (edits >= least) continue;
    least = edits;
    likely = other;
  }
  return likely;
}

std::string FileName(const std::string& path) { return path.substr(path.rfind('/') + 1); }

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::map<std::string, int> CountOutcomes(const std::vector<core::Episode>& episodes) {
  std::map<std::string, int> counts;
  for (const core::Episode& episode : episodes) {
    if (!episode.outcome.empty()) ++counts[episode.outcome];
  }
  return counts;
}

double MedianDuration(const std::vector<core::Episode>& episodes) {
  std::vector<double> durations;
  for (const core::Episode& episode : episodes) durations.push_back(episode.duration());
  return Median(durations);
}

}  // namespace contact_shapelets::cli
