#include "cli/text.h"

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace contact_shapelets::cli {

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
