#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/finding.h"
#include "contact_shapelets/core/model.h"
#include "contact_shapelets/core/stream_summary.h"
#include "contact_shapelets/ros/episode_bag_reader.h"

/// \file
/// What is in a bag, and what is wrong with it.

namespace contact_shapelets::cli {

/// The episodes that one way of cutting finds.
struct EpisodesFound {
  std::string way;                      ///< "recorded", "trigger", "contact" or "action"
  std::vector<core::Episode> episodes;  ///< none where `reason` says why
  int dropped = 0;                      ///< too short, or without a sample
  core::StreamSummary stream;           ///< of the wrench that they were cut from; no samples if they were recorded
  std::string reason;                   ///< why there is none
};

/// One topic of geometry_msgs/WrenchStamped.
struct WrenchTopic {
  std::string name;
  std::vector<std::string> frames;  ///< every frame_id that occurs
  int messages = 0;
  double received_duration = 0.0;  ///< [s] first to last receipt
  core::StreamSummary stream;
  std::vector<EpisodesFound> found;  ///< by each way of cutting
};

/// Any other topic.
struct OtherTopic {
  std::string name;
  std::string type;
  std::uint32_t messages = 0;
  std::string contents;  ///< what its messages say, for topics that mark episodes
};

/// What is in one bag.
struct BagInspection {
  core::Nanoseconds begin = 0;
  core::Nanoseconds end = 0;
  std::uint32_t messages = 0;
  std::uint64_t size = 0;  ///< [bytes]
  std::vector<WrenchTopic> wrenches;
  std::vector<EpisodesFound> recorded;  ///< of topics with Episode messages
  std::vector<OtherTopic> markers;      ///< topics that mark, name or hold episodes
  std::vector<OtherTopic> others;
  std::optional<core::Model> model;
  std::vector<core::Finding> findings;
};

/// Reads a bag wholly. `options.wrench_topic` leaves out the other wrench topics; empty: all.
/// \throws std::runtime_error in one line that names the bag where it cannot be read.
BagInspection InspectBag(const std::string& path, const BagReaderOptions& options, const ReadProgress& progress);

}  // namespace contact_shapelets::cli
