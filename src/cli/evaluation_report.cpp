#include "cli/evaluation_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <stdexcept>

namespace contact_shapelets::cli {
namespace {

using Score = std::function<double(const evaluation::EvaluationResult&)>;

/// Statistics of a score over the seeds of one data set and method.
struct Summary {
  int seeds = 0;
  double mean = 0.0;
  double deviation = 0.0;
  double best = 0.0;
};

Summary Summarise(const std::vector<evaluation::EvaluationResult>& results, const std::string& data_set,
                  const std::string& method, const Score& score) {
  std::vector<double> values;
  for (const evaluation::EvaluationResult& result : results) {
    if (result.data_set == data_set && result.method == method) values.push_back(score(result));
  }
  Summary summary;
  if (values.empty()) return summary;
  summary.seeds = static_cast<int>(values.size());
  summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / summary.seeds;
  summary.best = *std::max_element(values.begin(), values.end());
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  if (summary.seeds > 1) summary.deviation = std::sqrt(squares / (summary.seeds - 1));
  return summary;
}

using Cell = std::function<Summary(const std::string& data_set, const std::string& method)>;

void WriteAverages(const std::vector<std::string>& data_sets, const std::vector<std::string>& methods, const Cell& cell,
                   std::ostream* stream) {
  *stream << "| average |";
  for (const std::string& method : methods) {
    double sum = 0.0;
    int count = 0;
    for (const std::string& data_set : data_sets) {
      const Summary summary = cell(data_set, method);
      if (summary.seeds == 0) continue;
      sum += summary.mean;
      ++count;
    }
    char text[32] = "";
    // Averages over different data sets cannot be compared.
    const bool all = count == static_cast<int>(data_sets.size());
    if (all) std::snprintf(text, sizeof(text), " %.3f", sum / count);
    *stream << text << " |";
  }
  *stream << '\n';
}

void WriteTable(const std::string& title, const std::vector<std::string>& data_sets,
                const std::vector<std::string>& methods, const Cell& cell, std::ostream* stream) {
  *stream << "Rand index, " << title << ": mean ± standard deviation over seeds (best)\n\n| data set |";
  for (const std::string& method : methods) *stream << ' ' << method << " |";
  *stream << "\n|---|";
  for (std::size_t index = 0; index < methods.size(); ++index) *stream << "---|";
  *stream << '\n';
  for (const std::string& data_set : data_sets) {
    *stream << "| " << data_set << " |";
    for (const std::string& method : methods) {
      const Summary summary = cell(data_set, method);
      char text[64] = "";
      if (summary.seeds > 0) {
        std::snprintf(text, sizeof(text), " %.3f ± %.3f (%.3f)", summary.mean, summary.deviation, summary.best);
      }
      *stream << text << " |";
    }
    *stream << '\n';
  }
  if (data_sets.size() > 1) WriteAverages(data_sets, methods, cell, stream);
  *stream << '\n';
}

std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (static_cast<unsigned char>(letter) < 0x20) {
      char escaped[8];
      std::snprintf(escaped, sizeof(escaped), "\\u%04x", letter);
      quoted += escaped;
      continue;
    }
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

void WriteScores(const char* name, const evaluation::PartitionScores& scores, std::ostream* stream) {
  *stream << ", \"" << name << "\": {\"rand_index\": " << scores.rand_index
          << ", \"ari\": " << scores.adjusted_rand_index << ", \"nmi\": " << scores.normalised_mutual_information
          << ", \"acc\": " << scores.accuracy << '}';
}

}  // namespace

void WriteMarkdown(const std::vector<evaluation::EvaluationResult>& results, const std::vector<std::string>& data_sets,
                   const std::vector<std::string>& methods, std::ostream* stream) {
  const auto cell_of = [&results](const Score& score) {
    return [&results, score](const std::string& data_set, const std::string& method) {
      return Summarise(results, data_set, method, score);
    };
  };
  const Cell nearest = cell_of([](const evaluation::EvaluationResult& result) { return result.test.rand_index; });
  const Cell anew = cell_of([](const evaluation::EvaluationResult& result) { return result.test_anew.rand_index; });
  WriteTable("train", data_sets, methods,
             cell_of([](const evaluation::EvaluationResult& result) { return result.train.rand_index; }), stream);
  WriteTable("test by nearest centroid", data_sets, methods, nearest, stream);
  WriteTable("test clustered anew", data_sets, methods, anew, stream);
  WriteTable(
      "test, the better of the two means", data_sets, methods,
      [&](const std::string& data_set, const std::string& method) {
        const Summary first = nearest(data_set, method);
        const Summary second = anew(data_set, method);
        return second.mean > first.mean ? second : first;
      },
      stream);
}

void WriteJson(const std::vector<evaluation::EvaluationResult>& results, std::ostream* stream) {
  std::ostream& file = *stream;
  file << std::setprecision(9) << '[';
  for (std::size_t index = 0; index < results.size(); ++index) {
    const evaluation::EvaluationResult& result = results[index];
    file << (index == 0 ? "\n" : ",\n") << "  {\"dataset\": " << Quoted(result.data_set)
         << ", \"method\": " << Quoted(result.method) << ", \"seed\": " << result.seed;
    WriteScores("train", result.train, stream);
    WriteScores("test", result.test, stream);
    WriteScores("test_anew", result.test_anew, stream);
    file << ", \"fit_seconds\": " << result.fit_seconds
         << ", \"transform_ms_per_series\": " << result.transform_ms_per_series << '}';
  }
  file << "\n]\n";
}

}  // namespace contact_shapelets::cli
