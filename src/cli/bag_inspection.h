#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/finding.h"
#include "contact_shapelets/core/model.h"
#include "contact_shapelets/core/stream_summary.h"
#include "contact_shapelets/ros/episode_bag_reader.h"

/// \file
/// The contents of a bag, and findings about it.

namespace contact_shapelets::cli {

/// The episodes of a bag by one segmentation mode, or its recorded ones.
struct EpisodesFound {
  std::string mode;                     ///< "recorded", "trigger", "contact" or "action"
  std::vector<core::Episode> episodes;  ///< empty if there are none; see `reason`
  int dropped = 0;                      ///< number of episodes that are too short or have no sample
  core::StreamSummary stream;           ///< health of their wrench; no samples for recorded episodes
  std::string reason;                   ///< why there are no episodes
};

/// One topic of geometry_msgs/WrenchStamped.
struct WrenchTopic {
  std::string name;
  std::string type;
  std::vector<std::string> frames;  ///< every frame_id that occurs
  int messages = 0;
  double received_duration = 0.0;  ///< [s] from the first to the last receipt
  core::StreamSummary stream;
  std::vector<EpisodesFound> found;  ///< one for each segmentation mode
};

/// Any other topic.
struct OtherTopic {
  std::string name;
  std::string type;
  std::uint32_t messages = 0;
  std::string contents;  ///< counts of what its messages say, for topics that mark episodes
};

/// The contents of one bag.
struct BagInspection {
  core::Nanoseconds begin = 0;
  core::Nanoseconds end = 0;
  std::uint32_t messages = 0;
  std::uint64_t size = 0;  ///< [bytes]
  std::vector<WrenchTopic> wrenches;
  std::vector<EpisodesFound> recorded;  ///< episodes from topics with Episode messages
  std::vector<OtherTopic> markers;      ///< topics that mark, name or hold episodes
  std::vector<OtherTopic> others;
  std::optional<core::Model> model;
  std::vector<core::Finding> findings;
};

/// Inspects a whole bag. If `options.wrench_topic` is given, leaves out the other wrench topics.
/// \throws std::runtime_error in one line that names the bag if it cannot be read.
BagInspection InspectBag(const std::string& path, const BagReaderOptions& options, const ReadProgress& progress);

}  // namespace contact_shapelets::cli
