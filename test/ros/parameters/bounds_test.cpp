/// The bounds of each parameter are those of the README's tables, for the loader and in the comments of the YAML files
/// alike.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "ros/parameters/parameters.h"

namespace contact_shapelets {
namespace {

/// A row of a table: a number that may be set, from where to where.
struct Row {
  std::string name;
  std::string type;
  std::string least;
  std::string greatest;
};

/// One end of a range.
struct Bound {
  double value;
  bool inside;
};

std::string Contents(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string Trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// The rows with a range in the README's table of this node.
std::vector<Row> RowsOf(const std::string& node) {
  const std::string readme = Contents("README.md");
  const std::size_t table = readme.find("| name | type | default |", readme.find("\n**" + node + "**"));
  std::istringstream lines(readme.substr(table, readme.find("\n\n", table) - table));
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(Trimmed(cell));
    const bool ranged = cells.size() > 5 && cells[1].front() == '`' && !(cells[4] + cells[5]).empty();
    if (ranged) rows.push_back({cells[1].substr(1, cells[1].size() - 2), cells[2], cells[4], cells[5]});
  }
  return rows;
}

/// Such as "2", "above 0", or "`clusters`", which is that parameter's default.
Bound BoundOf(const std::string& text) {
  if (text == "`clusters`") return {static_cast<double>(core::TrainerOptions().clusters), true};
  const std::size_t space = text.rfind(' ');
  return {std::stod(text.substr(space == std::string::npos ? 0 : space)), space == std::string::npos};
}

/// Such as "(0, 1]".
std::string IntervalText(const Row& row) {
  const auto number = [](const std::string& text) {
    const std::string word = text.substr(text.rfind(' ') + 1);
    return word.front() == '`' ? word.substr(1, word.size() - 2) : word;
  };
  return (BoundOf(row.least).inside ? "[" : "(") + number(row.least) + ", " + number(row.greatest) +
         (BoundOf(row.greatest).inside ? "]" : ")");
}

/// How YAML 1.1 has a number.
std::string YamlOf(const Row& row, double value) {
  std::ostringstream text;
  text.precision(17);
  if (std::isnan(value)) {
    text << ".nan";
  } else if (std::isinf(value)) {
    text << (value < 0.0 ? "-.inf" : ".inf");
  } else if (row.type == "int") {
    text << static_cast<long long>(value);
  } else {
    text << std::fixed << value;
  }
  // A list has as many items as it has to; all but one are at a sound value.
  if (row.type == "double[]") return "[0.5, " + text.str() + "]";
  return text.str();
}

using Loader = std::function<void(ParameterReader*)>;

std::string FaultsOf(const Loader& load, const Row& row, double value) {
  const std::string path = testing::TempDir() + "bounds_test.yaml";
  std::ofstream(path) << row.name << ": " << YamlOf(row, value) << '\n';
  ParameterReader reader = ParameterReader::FromYaml({path});
  load(&reader);
  return reader.Faults();
}

double Step(const Row& row, double value) { return row.type == "int" ? 1.0 : std::max(1e-9, 1e-9 * std::abs(value)); }

/// The least and the greatest value that are allowed, and the next ones beyond them.
void ExpectBounds(const Loader& load, const Row& row) {
  const Bound least = BoundOf(row.least);
  const Bound greatest = BoundOf(row.greatest);
  const double first = least.inside ? least.value : least.value + Step(row, least.value);
  const double last = greatest.inside ? greatest.value : greatest.value - Step(row, greatest.value);
  EXPECT_EQ(FaultsOf(load, row, first), "") << row.name;
  EXPECT_EQ(FaultsOf(load, row, last), "") << row.name;
  std::vector<double> beyond{first - Step(row, first), last + Step(row, last)};
  if (row.type != "int") {
    beyond.insert(beyond.end(), {std::nan(""), std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(), -1e300, 1e300});
  } else {
    beyond.insert(beyond.end(), {static_cast<double>(std::numeric_limits<int>::min())});
  }
  for (const double value : beyond) {
    const std::string faults = FaultsOf(load, row, value);
    EXPECT_NE(faults.find(row.name + " must be "), std::string::npos) << row.name << " " << value << ": " << faults;
  }
}

struct Table {
  std::string node;
  std::string file;  ///< empty: it has none
  Loader load;
  std::size_t rows;
};

std::vector<Table> Tables() {
  return {
      {"trainer_node", "config/trainer.yaml", [](ParameterReader* reader) { ReadTrainerOptions(reader); }, 19},
      {"classifier_node", "config/classifier.yaml", [](ParameterReader* reader) { ReadClassifierOptions(reader); }, 3},
      {"wrench_adapter_node", "", [](ParameterReader* reader) { ReadAdapterOptions(reader); }, 1}};
}

TEST(Bounds, EachNumberIsTakenAtItsExtremesAndRefusedBeyondThem) {
  for (const Table& table : Tables()) {
    const std::vector<Row> rows = RowsOf(table.node);
    EXPECT_EQ(rows.size(), table.rows) << table.node;
    for (const Row& row : rows) {
      ASSERT_FALSE(row.least.empty() || row.greatest.empty()) << row.name << " has no bound on one side";
      ExpectBounds(table.load, row);
    }
  }
}

TEST(Bounds, AFaultNamesTheRangeOfTheReadme) {
  for (const Table& table : Tables()) {
    for (const Row& row : RowsOf(table.node)) {
      std::string interval = IntervalText(row);
      const std::size_t clusters = interval.find("clusters");
      if (clusters != std::string::npos) interval.replace(clusters, 8, "3");
      EXPECT_NE(FaultsOf(table.load, row, -5.0).find(interval), std::string::npos) << row.name << " " << interval;
    }
  }
}

TEST(Bounds, TheYamlFileNamesTheRangeOfTheReadme) {
  for (const Table& table : Tables()) {
    if (table.file.empty()) continue;
    const std::string yaml = "\n" + Contents(table.file);
    for (const Row& row : RowsOf(table.node)) {
      const std::size_t value = yaml.find("\n" + row.name + ": ");
      ASSERT_NE(value, std::string::npos) << row.name;
      const std::string comment = yaml.substr(yaml.rfind("\n\n", value), value - yaml.rfind("\n\n", value));
      EXPECT_NE(comment.find(IntervalText(row)), std::string::npos) << row.name << " " << IntervalText(row);
    }
  }
}

TEST(Bounds, OfScalesThereAreOneToAHundred) {
  core::LearnerOptions options;
  options.scales.assign(100, 0.5);
  EXPECT_EQ(options.Faults(), "");
  options.scales.push_back(0.5);
  EXPECT_EQ(options.Faults(), "the number of scales must be in [1, 100], but is 101\n");
  options.scales.clear();
  EXPECT_EQ(options.Faults(), "the number of scales must be in [1, 100], but is 0\n");
}

}  // namespace
}  // namespace contact_shapelets
