/// Covering of the change points that ClaSP and ClaSS find in series with known ones.
///
///   segmentation_covering FILE.csv [--given-windows] [--max-samples N] [--warm-up N] [--sliding-window N] [--stride N]
///
/// FILE.csv is that of the Time Series Segmentation Benchmark: columns dataset, window_size, change_points,
/// time_series. A table with a row for each series goes to stdout, as CSV; the means follow on stderr. --given-windows
/// takes the file's window sizes instead of those that are chosen.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/change_points/clasp.h"
#include "core/change_points/streaming_clasp.h"
#include "evaluation/covering.h"

namespace {

using contact_shapelets::core::ChangePoint;
using contact_shapelets::core::ClaspOptions;
using contact_shapelets::core::StreamingClasp;
using contact_shapelets::core::StreamingClaspOptions;
using contact_shapelets::evaluation::Covering;
using Indices = std::vector<std::int64_t>;

struct AnnotatedSeries {
  std::string name;
  int window = 0;
  Indices change_points;
  std::vector<double> samples;
};

struct Arguments {
  std::string path;
  bool given_windows = false;
  ClaspOptions offline;
  StreamingClaspOptions streaming;
};

struct Result {
  Indices found;
  double covering = 0.0;
  double seconds = 0.0;
  double mean_delay = 0.0;  ///< [samples] from a change point to its report
  int window = 0;
};

Arguments Parse(int count, char** values) {
  Arguments arguments;
  for (int index = 1; index < count; ++index) {
    const std::string value = values[index];
    const auto number = [&] {
      if (index + 1 >= count) throw std::invalid_argument(value + " needs a number");
      return std::stoi(values[++index]);
    };
    if (value == "--given-windows") {
      arguments.given_windows = true;
    } else if (value == "--max-samples") {
      arguments.offline.max_samples = number();
    } else if (value == "--warm-up") {
      arguments.streaming.warm_up = number();
    } else if (value == "--sliding-window") {
      arguments.streaming.sliding_window = number();
    } else if (value == "--stride") {
      arguments.streaming.stride = number();
    } else if (arguments.path.empty() && value.rfind("--", 0) != 0) {
      arguments.path = value;
    } else {
      throw std::invalid_argument("unknown argument " + value);
    }
  }
  if (arguments.path.empty()) throw std::invalid_argument("the path of a CSV file is missing");
  return arguments;
}

/// The numbers of the next list in brackets.
std::vector<double> ReadList(std::istream& line) {
  std::string text;
  std::getline(line, text, '[');
  std::getline(line, text, ']');
  std::istringstream values(text);
  std::vector<double> list;
  for (std::string value; std::getline(values, value, ',');) list.push_back(std::stod(value));
  return list;
}

std::vector<AnnotatedSeries> Read(const std::string& path) {
  std::ifstream file(path);
  std::string text;
  if (!std::getline(file, text)) throw std::invalid_argument(path + ": expected a CSV file with a header");
  std::vector<AnnotatedSeries> all;
  while (std::getline(file, text)) {
    std::istringstream line(text);
    AnnotatedSeries series;
    std::string window;
    std::getline(line, series.name, ',');
    std::getline(line, window, ',');
    series.window = std::stoi(window);
    for (const double change_point : ReadList(line)) series.change_points.push_back(std::llround(change_point));
    series.samples = ReadList(line);
    all.push_back(series);
  }
  if (all.empty()) throw std::invalid_argument(path + ": expected a row for each series, found none");
  return all;
}

/// Seconds of processor time: other programs do not count.
double Seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Result RunOffline(const AnnotatedSeries& series, const ClaspOptions& options) {
  const Eigen::Map<const Eigen::VectorXd> samples(series.samples.data(), static_cast<int>(series.samples.size()));
  const double start = Seconds();
  const auto found = FindChangePoints(samples, options);
  Result result;
  result.seconds = Seconds() - start;
  result.window = found.window;
  for (const ChangePoint& point : found.points) result.found.push_back(point.index);
  return result;
}

Result RunStreaming(const AnnotatedSeries& series, const StreamingClaspOptions& options) {
  Result result;
  std::int64_t appended = 0;
  const auto take = [&](const std::vector<ChangePoint>& found) {
    for (const ChangePoint& point : found) {
      result.mean_delay += static_cast<double>(appended - point.index);
      result.found.push_back(point.index);
    }
  };
  const double start = Seconds();
  StreamingClasp clasp(options);
  for (const double sample : series.samples) {
    ++appended;
    take(clasp.Append(sample));
  }
  take(clasp.Flush());
  result.seconds = Seconds() - start;
  result.window = clasp.window();
  if (!result.found.empty()) result.mean_delay /= static_cast<double>(result.found.size());
  return result;
}

void Print(const AnnotatedSeries& series, const char* method, const Result& result) {
  std::cout << series.name << ',' << method << ',' << series.samples.size() << ',' << result.window << ','
            << series.change_points.size() << ',' << result.found.size() << ',' << result.covering << ','
            << result.mean_delay << ',' << result.seconds << '\n';
}

constexpr std::size_t kOneMinute = 60000;

/// The first samples of all series, one after the other, and again.
AnnotatedSeries MinuteOfSeries(const std::vector<AnnotatedSeries>& all) {
  AnnotatedSeries minute;
  for (std::size_t index = 0; minute.samples.size() < kOneMinute; index = (index + 1) % all.size()) {
    const std::vector<double>& samples = all[index].samples;
    minute.samples.insert(minute.samples.end(), samples.begin(), samples.end());
  }
  minute.samples.resize(kOneMinute);
  return minute;
}

/// White noise, uniform in [0, 1).
AnnotatedSeries MinuteOfNoise() {
  AnnotatedSeries minute;
  std::mt19937 random(1);
  while (minute.samples.size() < kOneMinute) minute.samples.push_back(std::ldexp(static_cast<double>(random()), -32));
  return minute;
}

void PrintTime(const char* name, const AnnotatedSeries& minute, const Arguments& arguments) {
  std::cerr << minute.samples.size() << " samples of " << name << ": " << RunOffline(minute, arguments.offline).seconds
            << " s offline, " << RunStreaming(minute, arguments.streaming).seconds << " s streaming\n";
}

void Run(const Arguments& arguments) {
  const std::vector<AnnotatedSeries> all = Read(arguments.path);
  Result offline_sum;
  Result streaming_sum;
  std::cout << "dataset,method,samples,window,change_points,found,covering,mean_delay,seconds\n";
  for (const AnnotatedSeries& series : all) {
    ClaspOptions offline = arguments.offline;
    StreamingClaspOptions streaming = arguments.streaming;
    if (arguments.given_windows) offline.window = streaming.window = series.window;
    const auto score = [&](const char* method, Result result, Result* sum) {
      result.covering = Covering(series.change_points, result.found, static_cast<std::int64_t>(series.samples.size()));
      Print(series, method, result);
      sum->covering += result.covering / static_cast<double>(all.size());
      sum->seconds += result.seconds;
    };
    score("offline", RunOffline(series, offline), &offline_sum);
    score("streaming", RunStreaming(series, streaming), &streaming_sum);
  }
  std::cerr << all.size() << " series: mean covering " << offline_sum.covering << " offline in " << offline_sum.seconds
            << " s, " << streaming_sum.covering << " streaming in " << streaming_sum.seconds << " s\n";
  PrintTime("these series", MinuteOfSeries(all), arguments);
  PrintTime("noise, without a change", MinuteOfNoise(), arguments);
}

}  // namespace

int main(int count, char** values) {
  try {
    Run(Parse(count, values));
  } catch (const std::exception& error) {
    std::cerr << "segmentation_covering: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
