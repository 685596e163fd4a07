#include "cli/inspect_command.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "cli/bag_inspection.h"
#include "cli/common.h"
#include "cli/text.h"

namespace contact_shapelets::cli {
namespace {

constexpr std::size_t kLabelWidth = 12;

void Line(const std::string& label, const std::string& text) {
  std::cout << "    " << Padded(label, kLabelWidth) << text << '\n';
}

/// Returns a time in seconds, or in milliseconds below 1 s.
std::string ShortTime(double seconds) {
  return seconds < 1.0 ? Number(1000.0 * seconds, 1) + " ms" : Number(seconds, 2) + " s";
}

std::string SizeText(std::uint64_t bytes) {
  const double kilobytes = static_cast<double>(bytes) / 1000.0;
  return kilobytes < 1000.0 ? Number(kilobytes, 1) + " kB" : Number(kilobytes / 1000.0, 1) + " MB";
}

std::string EpisodesText(const EpisodesFound& found) {
  if (found.episodes.empty()) return "none: " + found.reason;
  double shortest = found.episodes.front().duration();
  double longest = shortest;
  for (const core::Episode& episode : found.episodes) {
    shortest = std::min(shortest, episode.duration());
    longest = std::max(longest, episode.duration());
  }
  const std::string outcomes = CountsText(CountOutcomes(found.episodes));
  const std::string range = Number(shortest, 2) == Number(longest, 2)
                                ? Number(longest, 2) + " s"
                                : Number(shortest, 2) + " to " + Number(longest, 2) + " s, median " +
                                      Number(MedianDuration(found.episodes), 2) + " s";
  return Count(found.episodes.size(), "episode") + " of " + range + (outcomes.empty() ? "" : ": " + outcomes);
}

std::string StampText(const WrenchTopic& wrench) {
  const core::StreamSummary& stream = wrench.stream;
  if (stream.zero_stamps > 0 && stream.zero_stamps + stream.not_finite >= wrench.messages) {
    return "none: header.stamp is zero";
  }
  const std::string zeros = stream.zero_stamps > 0 ? ", " + std::to_string(stream.zero_stamps) + " of them zero" : "";
  const std::string side = stream.clock_offset < 0.0 ? " after" : " before";
  return "at least " + ShortTime(std::abs(stream.clock_offset)) + side + " the time of receipt" + zeros;
}

std::string ForceText(const core::StreamSummary& stream) {
  std::string text;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    text += std::string(1, "xyz"[axis]) + " " + Number(stream.least_components[axis], 2) + " to " +
            Number(stream.greatest_components[axis], 2) + ", ";
  }
  return text + "magnitude " + Number(stream.least_force, 2) + " to " + Number(stream.greatest_force, 2) + " N";
}

void PrintWrench(const WrenchTopic& wrench) {
  const core::StreamSummary& stream = wrench.stream;
  std::vector<std::string> frames = wrench.frames;
  std::replace(frames.begin(), frames.end(), std::string(), std::string("(empty)"));
  std::cout << "  " << wrench.name << "  " << wrench.type << ", frame " << Joined(frames, ", ") << '\n';
  const double received = wrench.received_duration > 0.0 ? (wrench.messages - 1) / wrench.received_duration : 0.0;
  Line("messages", std::to_string(wrench.messages) + " over " + Number(wrench.received_duration, 2) + " s, " +
                       Number(received, 1) + " Hz as received");
  Line("samples", std::to_string(stream.samples) + " used, " + std::to_string(stream.not_finite) +
                      " NaN, infinite or above 1e6 N, " + std::to_string(stream.repeated + stream.repeated_messages) +
                      " repeated, " + std::to_string(stream.out_of_order) + " out of order");
  if (stream.samples > 1) {
    Line("intervals", "mean " + ShortTime(1.0 / stream.rate) + " (" + Number(stream.rate, 1) + " Hz), jitter " +
                          ShortTime(stream.jitter) + ", " + Count(static_cast<std::size_t>(stream.gaps), "gap") +
                          ", longest " + ShortTime(stream.longest_interval));
  }
  if (stream.samples > 0) {
    Line("stamps", StampText(wrench));
    Line("force", ForceText(stream));
  }
  for (std::size_t index = 0; index < wrench.found.size(); ++index) {
    Line(index == 0 ? "episodes" : "", Padded(wrench.found[index].mode, 9) + EpisodesText(wrench.found[index]));
  }
}

void PrintModel(const core::Model& model) {
  std::vector<double> spans;
  for (const core::Shapelet& shapelet : model.shapelets) {
    spans.push_back(static_cast<double>(shapelet.values.size()) * shapelet.dilation * model.sample_period);
  }
  const auto [shortest, longest] = std::minmax_element(spans.begin(), spans.end());
  std::cout << "  model " << model.id << '\n';
  Line("shapelets", std::to_string(model.shapelets.size()) + " of " + Number(*shortest, 2) + " to " +
                        Number(*longest, 2) + " s, sample period " + Number(model.sample_period, 4) + " s");
  for (std::size_t index = 0; index < model.clusters.size(); ++index) {
    const core::Cluster& cluster = model.clusters[index];
    Line("cluster " + std::to_string(index), Count(static_cast<std::size_t>(cluster.size), "episode") + ", event " +
                                                 model.EventOf(static_cast<int>(index)) +
                                                 (cluster.label.empty() ? " (not named)" : ""));
  }
  const core::Preparation& preparation = model.preparation;
  if (preparation.segmentation) {
    Line("cut by", "segmentation " + core::NameOf(preparation.segmentation->segmentation) + ", tare " +
                       core::NameOf(preparation.segmentation->tare) +
                       (preparation.topic.empty() ? "" : ", from " + preparation.topic));
  }
  if (preparation.greatest_duration > 0.0) {
    Line("ranges", Number(preparation.least_duration, 2) + " to " + Number(preparation.greatest_duration, 2) +
                       " s, greatest forces " + Number(preparation.least_peak, 1) + " to " +
                       Number(preparation.greatest_peak, 1) + " N");
  }
  const core::Provenance& provenance = model.provenance;
  Line("trained on", Count(static_cast<std::size_t>(provenance.training_episodes), "episode") + " of " +
                         Number(provenance.typical_duration, 2) + " s (median) from " +
                         Joined(provenance.sources, ", "));
  std::vector<std::string> scales;
  for (const double scale : provenance.selected_scales) scales.push_back(Number(scale, 2));
  Line("learned by", "the " + provenance.objective + " objective, scales " + Joined(scales, " ") + ", seed " +
                         std::to_string(provenance.seed));
}

void PrintTopics(const std::string& title, const std::vector<OtherTopic>& topics) {
  if (topics.empty()) return;
  std::size_t width = 0;
  for (const OtherTopic& topic : topics) width = std::max(width, topic.name.size());
  std::cout << "  " << title << '\n';
  for (const OtherTopic& topic : topics) {
    std::cout << "    " << Padded(topic.name, width + 2) << topic.type << ", " << Count(topic.messages, "message")
              << (topic.contents.empty() ? "" : ": " + topic.contents) << '\n';
  }
}

void Print(const std::string& path, const BagInspection& inspection) {
  std::cout << path << '\n';
  std::cout << "  " << Count(inspection.messages, "message") << ", " << SizeText(inspection.size) << ", from "
            << DateText(inspection.begin) << " UTC, " << Number(core::ToSeconds(inspection.end - inspection.begin), 1)
            << " s\n";
  for (const WrenchTopic& wrench : inspection.wrenches) PrintWrench(wrench);
  if (inspection.model) PrintModel(*inspection.model);
  for (const EpisodesFound& found : inspection.recorded) {
    std::cout << "  recorded episodes\n";
    Line("episodes", EpisodesText(found));
  }
  PrintTopics("episode markers", inspection.markers);
  if (inspection.markers.empty()) std::cout << "  episode markers: none\n";
  PrintTopics("other topics", inspection.others);
  if (inspection.findings.empty()) std::cout << "  findings: none\n";
  if (!inspection.findings.empty()) std::cout << "  findings\n";
  for (const core::Finding& finding : inspection.findings) {
    std::cout << "    " << finding.text << "\n      what to do: " << finding.remedy << '\n';
  }
}

/// Inspects all bags, even if some of them cannot be read.
void Inspect(const BagArguments& arguments) {
  const BagReaderOptions options = ReadOptions(arguments).reader;
  std::vector<std::string> unreadable;
  for (const std::string& path : arguments.bags) {
    try {
      ProgressLine line("reading " + FileName(path));
      const BagInspection inspection = InspectBag(path, options, [&line](double done) { line.Show(done); });
      line.Clear();
      Print(path, inspection);
    } catch (const std::exception& error) {
      unreadable.emplace_back(error.what());
      std::cout << path << "\n  it cannot be read\n";
    }
  }
  if (!unreadable.empty()) throw std::runtime_error(Joined(unreadable, "\n"));
}

}  // namespace

Command InspectCommand() {
  Command command;
  command.name = "inspect";
  command.description = "Shows the contents of bags and models, what is wrong with them, and what to do";
  command.usage = "BAG...";
  const auto arguments = std::make_shared<BagArguments>();
  AddBagArguments(&command, arguments.get());
  command.run = [arguments] {
    Inspect(*arguments);
    return 0;
  };
  return command;
}

}  // namespace contact_shapelets::cli
