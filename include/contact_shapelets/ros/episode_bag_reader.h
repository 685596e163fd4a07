#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/preparation.h"
#include "contact_shapelets/core/segmentation_options.h"
#include "contact_shapelets/core/stream_summary.h"
#include "contact_shapelets/ros/wrench_source.h"

/// \file
/// Reads episodes from recorded bags. The classes that cut the live stream cut the recorded one too.

namespace contact_shapelets {

/// What to read.
struct BagReaderOptions {
  core::SegmentationOptions segmentation;  ///< how to cut raw wrench into episodes
  /// If empty, the only WrenchStamped topic. If given, Episode messages are not read, and the topic may be of another
  /// type, which `source` describes.
  std::string wrench_topic;
  WrenchSource source;  ///< where the wrench comes from, if it is not a WrenchStamped
};

/// The contents of one bag.
struct BagContents {
  std::vector<core::Episode> episodes;  ///< in order of their ends, with the outcomes that the bag gives them
  core::StreamSummary stream;     ///< health of the wrench and its episodes; no samples if Episode messages were read
  int dropped_episodes = 0;       ///< number of episodes that are too short or have no sample
  core::Preparation preparation;  ///< how the episodes were made; no segmentation if Episode messages were read
};

/// Called with the part of the bag that was read, in [0, 1]. May throw core::Cancelled to stop the reading.
using ReadProgress = std::function<void(double)>;

/// Reads the episodes of one bag: its Episode messages if it has any, else the raw wrench with its triggers.
///
/// \throws std::runtime_error in one line that names the bag: no such file, not a bag, cut off, no WrenchStamped topic
/// or more than one, no episode in it.
BagContents ReadEpisodes(const std::string& path, const BagReaderOptions& options,
                         const ReadProgress& progress = nullptr);

/// Reads the episodes of several bags, one after the other. Sets `preparation`, unless it is null, to what the bags
/// have in common. \throws std::runtime_error as ReadEpisodes() does, or if `paths` is empty.
std::vector<core::Episode> ReadAllEpisodes(const std::vector<std::string>& paths, const BagReaderOptions& options,
                                           const ReadProgress& progress = nullptr,
                                           core::Preparation* preparation = nullptr);

}  // namespace contact_shapelets
