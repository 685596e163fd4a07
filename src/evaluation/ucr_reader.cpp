#include "evaluation/ucr_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/numerics/series.h"

namespace contact_shapelets::evaluation {
namespace {

namespace fs = std::filesystem;

/// The contents of one file.
struct UcrFile {
  std::string path;
  std::vector<double> classes;
  std::vector<Eigen::VectorXf> series;
  std::vector<int> rows;  ///< the row of each series in the file, from 1
};

[[noreturn]] void Fail(const std::string& path, int row, const std::string& what) {
  throw std::runtime_error(path + ": row " + std::to_string(row) + ": " + what);
}

std::vector<std::string> Fields(std::string line) {
  std::vector<std::string> fields;
  const bool commas = line.find(',') != std::string::npos;
  const bool tabs = line.find('\t') != std::string::npos;
  const char* separators = commas ? "," : tabs ? "\t" : " ";
  const std::string blank = " \t\r";
  const auto trimmed = [&blank](const std::string& text) {
    const std::size_t first = text.find_first_not_of(blank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
  };
  line = trimmed(line);
  std::size_t start = 0;
  while (start <= line.size()) {
    const std::size_t end = std::min(line.find_first_of(separators, start), line.size());
    const std::string field = trimmed(line.substr(start, end - start));
    // Several spaces are one separator. Between two commas or tabs there is an empty value.
    if (!field.empty() || commas || tabs) fields.push_back(field);
    start = end + 1;
  }
  return fields;
}

double Number(const std::string& text, const std::string& path, int row, std::size_t column) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') {
    Fail(path, row, "column " + std::to_string(column + 1) + " holds '" + text + "', which is not a number");
  }
  if (std::abs(value) > std::numeric_limits<float>::max()) {
    Fail(path, row, "column " + std::to_string(column + 1) + " holds an infinite value");
  }
  return value;
}

/// Returns `values` without the padding at their end, and with missing values interpolated.
Eigen::VectorXf WithoutMissing(std::vector<double> values) {
  while (!values.empty() && std::isnan(values.back())) values.pop_back();
  Eigen::VectorXf series(values.size());
  int last = -1;
  for (int index = 0; index < static_cast<int>(values.size()); ++index) {
    if (std::isnan(values[index])) continue;
    const double before = last < 0 ? values[index] : values[last];
    for (int missing = last + 1; missing < index; ++missing) {
      const double part = static_cast<double>(missing - last) / (index - last);
      series[missing] = static_cast<float>(before + part * (values[index] - before));
    }
    series[index] = static_cast<float>(values[index]);
    last = index;
  }
  return series;
}

void AddRow(const std::vector<std::string>& fields, int row, UcrFile* file) {
  const double label = Number(fields.front(), file->path, row, 0);
  if (std::isnan(label)) Fail(file->path, row, "the class is NaN");
  std::vector<double> values;
  for (std::size_t column = 1; column < fields.size(); ++column) {
    values.push_back(Number(fields[column], file->path, row, column));
  }
  Eigen::VectorXf series = WithoutMissing(std::move(values));
  if (series.size() < 2) Fail(file->path, row, "the series has fewer than 2 values");
  if (core::ZNormalised(series).isZero()) Fail(file->path, row, "the series is constant");
  file->classes.push_back(label);
  file->series.push_back(std::move(series));
  file->rows.push_back(row);
}

UcrFile ReadFile(const std::string& path) {
  UcrFile file;
  file.path = path;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(path + ": the file cannot be opened");
  std::size_t width = 0;
  int row = 0;
  for (std::string line; std::getline(stream, line);) {
    ++row;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::vector<std::string> fields = Fields(line);
    if (width == 0) width = fields.size();
    if (fields.size() != width) {
      Fail(
          path, row,
          "expected " + std::to_string(width) + " columns as in the first row, found " + std::to_string(fields.size()));
    }
    AddRow(fields, row, &file);
  }
  if (file.series.empty()) throw std::runtime_error(path + ": row 1: expected a series, but the file is empty");
  return file;
}

const std::vector<std::string>& Endings() {
  static const std::vector<std::string> endings{".tsv", ".txt", ".csv", ""};
  return endings;
}

std::string FindSplit(const std::string& folder, const std::string& name, const std::string& split) {
  for (const fs::path& place : {fs::path(folder) / name, fs::path(folder)}) {
    for (const std::string& ending : Endings()) {
      const fs::path path = place / (name + "_" + split + ending);
      if (fs::is_regular_file(path)) return path.string();
    }
  }
  const fs::path expected = fs::path(folder) / name / (name + "_" + split + ".tsv");
  throw std::runtime_error(expected.string() + ": there is no such file (nor with the ending .txt, .csv or none)");
}

/// Returns the number of members of each class in `file`, and the row of the last one.
std::map<double, std::pair<int, int>> Members(const UcrFile& file) {
  std::map<double, std::pair<int, int>> members;
  for (std::size_t index = 0; index < file.classes.size(); ++index) {
    ++members[file.classes[index]].first;
    members[file.classes[index]].second = file.rows[index];
  }
  return members;
}

std::string ClassText(double label) {
  std::string text = std::to_string(label);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

void CheckMembers(const UcrFile& file, const UcrFile& other, std::vector<std::string>* notes) {
  const auto others = Members(other);
  for (const auto& [label, members] : Members(file)) {
    if (members.first > 1) continue;
    const auto found = others.find(label);
    const std::string what = "class " + ClassText(label) + " has one member";
    if (found == others.end() || found->second.first < 2) {
      Fail(file.path, members.second, what + ", expected 2 or more");
    }
    if (notes != nullptr) notes->push_back(file.path + ": row " + std::to_string(members.second) + ": " + what);
  }
}

void CheckCount(const UcrFile& file, std::size_t class_count) {
  if (class_count < 2) Fail(file.path, file.rows.back(), "the data set ends with 1 class, expected 2 or more");
  if (file.series.size() >= class_count) return;
  Fail(file.path, file.rows.back(),
       "the file ends with " + std::to_string(file.series.size()) + " series, fewer than the " +
           std::to_string(class_count) + " classes of the data set");
}

LabelledSeries Numbered(UcrFile file, const std::map<double, int>& numbers) {
  LabelledSeries labelled;
  labelled.series = std::move(file.series);
  labelled.classes.resize(static_cast<Eigen::Index>(file.classes.size()));
  for (std::size_t index = 0; index < file.classes.size(); ++index) {
    labelled.classes[static_cast<Eigen::Index>(index)] = numbers.at(file.classes[index]);
  }
  return labelled;
}

}  // namespace

DataSet ReadUcrDataSet(const std::string& folder, const std::string& name, std::vector<std::string>* notes) {
  UcrFile train = ReadFile(FindSplit(folder, name, "TRAIN"));
  UcrFile test = ReadFile(FindSplit(folder, name, "TEST"));
  std::map<double, int> numbers;
  for (const UcrFile* file : {&train, &test}) {
    for (const double label : file->classes) numbers.emplace(label, 0);
  }
  int next = 0;
  for (auto& [label, number] : numbers) number = next++;
  for (const UcrFile* file : {&train, &test}) {
    CheckCount(*file, numbers.size());
    CheckMembers(*file, file == &train ? test : train, notes);
  }
  DataSet data_set;
  data_set.name = name;
  data_set.train = Numbered(std::move(train), numbers);
  data_set.test = Numbered(std::move(test), numbers);
  data_set.class_count = next;
  return data_set;
}

std::vector<std::string> UcrDataSetNames(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder + ": expected a folder with data sets, found none");
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory()) continue;
    for (const std::string& ending : Endings()) {
      if (!fs::is_regular_file(entry.path() / (name + "_TRAIN" + ending))) continue;
      names.push_back(name);
      break;
    }
  }
  if (names.empty()) throw std::runtime_error(folder + ": expected folders such as CBF with CBF_TRAIN.tsv, found none");
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace contact_shapelets::evaluation
