#include "cli/segment_command.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/common.h"
#include "cli/text.h"
#include "core/change_points/clasp.h"
#include "core/change_points/streaming_clasp.h"
#include "ros/bags/output_file.h"
#include "ros/bags/wrench_recording.h"

namespace contact_shapelets::cli {
namespace {

struct Arguments {
  BagArguments bags;
  std::string csv;
  double window = 0.0;
  bool streaming = false;
};

/// The change points of one recording and the window that was compared.
struct Found {
  std::vector<core::ChangePoint> points;
  double window = 0.0;  ///< [s]
};

Found FindChanges(const WrenchRecording& recording, const Arguments& arguments) {
  const auto window = static_cast<int>(std::lround(arguments.window / recording.sample_period));
  const Eigen::VectorXd force = recording.force.cast<double>();
  if (!arguments.streaming) {
    core::ClaspOptions options;
    options.window = window;
    core::ChangePoints changes = core::FindChangePoints(force, options);
    return {std::move(changes.points), changes.window * recording.sample_period};
  }
  core::StreamingClaspOptions options;
  options.window = window;
  core::StreamingClasp clasp(options);
  Found found;
  for (Eigen::Index index = 0; index < force.size(); ++index) {
    for (const core::ChangePoint& point : clasp.Append(force[index])) found.points.push_back(point);
  }
  for (const core::ChangePoint& point : clasp.Flush()) found.points.push_back(point);
  found.window = clasp.window() * recording.sample_period;
  return found;
}

/// Writes one row for each interval between change points.
void WriteIntervals(const std::string& bag, const WrenchRecording& recording, const Found& found, std::ostream* table) {
  const double start = core::ToSeconds(recording.begin);
  const double end = recording.sample_period * static_cast<double>(recording.force.size());
  double from = 0.0;
  for (std::size_t index = 0; index <= found.points.size(); ++index) {
    const bool last = index == found.points.size();
    const double to = last ? end : recording.sample_period * static_cast<double>(found.points[index].index);
    const std::string score = last ? "" : Number(found.points[index].score, 3);
    std::printf("  %10.2f to %10.2f s  %8.2f s%s%s\n", from, to, to - from, last ? "" : "  change ", score.c_str());
    if (table != nullptr) {
      *table << bag << ',' << Number(start + from, 3) << ',' << Number(start + to, 3) << ',' << score << '\n';
    }
    from = to;
  }
}

void Segment(const Arguments& arguments) {
  const BagReaderOptions options = ReadOptions(arguments.bags).reader;
  std::unique_ptr<OutputFile> file;
  std::ofstream table;
  if (!arguments.csv.empty()) {
    CheckTextOutput("--csv", arguments.csv, FilesRead(arguments.bags));
    file = std::make_unique<OutputFile>(arguments.csv);
    table.open(file->unfinished());
    table << "bag,start,end,score\n";
  }
  for (const std::string& bag : arguments.bags.bags) {
    const WrenchRecording recording =
        ReadWrenchRecording(bag, options.wrench_topic, options.segmentation.sample_period, options.source);
    Found found;
    try {
      found = FindChanges(recording, arguments);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(bag + ": " + error.what());
    }
    std::printf("%s: %s on %s, windows of %.2f s\n", bag.c_str(), Count(found.points.size(), "change").c_str(),
                recording.topic.c_str(), found.window);
    WriteIntervals(bag, recording, found, file ? &table : nullptr);
  }
  if (!file) return;
  table.close();
  if (!table) throw std::runtime_error(arguments.csv + " cannot be written");
  file->Finish();
}

}  // namespace

Command SegmentCommand() {
  namespace po = boost::program_options;
  Command command;
  command.name = "segment";
  command.description = "Finds where the shape of a recorded wrench changes, without triggers and without a model";
  command.usage = "BAG...";
  const auto arguments = std::make_shared<Arguments>();
  AddBagArguments(&command, &arguments->bags);
  command.options.add_options()("csv", po::value(&arguments->csv), "Table to write: bag,start,end,score");
  command.options.add_options()("window", po::value(&arguments->window)->notifier([](double seconds) {
    if (!(seconds > 0.0 && seconds <= 600.0)) throw UsageError("--window must be in (0, 600] s");
  }),
                                "Length of the windows that are compared [s] (default: chosen by the series)");
  command.options.add_options()("streaming", po::bool_switch(&arguments->streaming),
                                "Find changes as they could be found live: for long recordings");
  command.run = [arguments] {
    Segment(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
