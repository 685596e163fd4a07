#include "cli/outcome_labels.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

namespace contact_shapelets::cli {
namespace {

/// Returns the cells of one line.
std::vector<std::string> CellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t index = 0; index < line.size(); ++index) {
    const char letter = line[index];
    const bool doubled = quoted && letter == '"' && index + 1 < line.size() && line[index + 1] == '"';
    if (doubled) {
      cells.back() += line[++index];
    } else if (letter == '"') {
      quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += letter;
    }
  }
  return cells;
}

std::map<std::string, std::vector<core::Episode*>> ById(std::vector<core::Episode>* episodes) {
  std::map<std::string, std::vector<core::Episode*>> by_id;
  for (core::Episode& episode : *episodes) by_id[episode.id].push_back(&episode);
  return by_id;
}

}  // namespace

void SetOutcomes(const std::string& path, std::vector<core::Episode>* episodes) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": expected a table of episode_id,outcome, but it cannot be read");
  const std::map<std::string, std::vector<core::Episode*>> by_id = ById(episodes);
  std::set<std::string> named;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || (number == 1 && line == "episode_id,outcome")) continue;
    const std::string where = path + ", line " + std::to_string(number) + ": ";
    const std::vector<std::string> cells = CellsOf(line);
    if (cells.size() != 2) {
      throw std::runtime_error(where + "expected episode_id,outcome, but found " + std::to_string(cells.size()) +
                               (cells.size() == 1 ? " column" : " columns"));
    }
    const auto found = by_id.find(cells[0]);
    if (found == by_id.end()) throw std::runtime_error(where + "the bags have no episode " + cells[0]);
    if (found->second.size() > 1) {
      throw std::runtime_error(where + "the bags have " + std::to_string(found->second.size()) + " episodes " +
                               cells[0] + ", expected one");
    }
    if (!named.insert(cells[0]).second) throw std::runtime_error(where + "episode " + cells[0] + " comes twice");
    found->second.front()->outcome = cells[1];
  }
}

}  // namespace contact_shapelets::cli
