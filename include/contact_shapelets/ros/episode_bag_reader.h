#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/segmentation_options.h"
#include "contact_shapelets/core/stream_summary.h"

/// \file
/// Episodes out of recorded bags, by the same classes that cut the live stream.

namespace contact_shapelets {

/// What to read.
struct BagReaderOptions {
  core::SegmentationOptions segmentation;  ///< how raw wrench is cut
  std::string wrench_topic;  ///< empty: the only WrenchStamped; a name also wins over Episode messages in the bag
};

/// What was in one bag.
struct BagContents {
  std::vector<core::Episode> episodes;  ///< in order of their ends, with the outcomes that the bag gives them
  core::StreamSummary stream;           ///< of the wrench and of what was cut; no samples if Episode messages were read
  int dropped_episodes = 0;             ///< too short, or without a sample
};

/// Called with the part of the bag that was read, [0, 1]. It may throw core::Cancelled, which passes through.
using ReadProgress = std::function<void(double)>;

/// Reads the episodes of one bag as a stream: Episode messages where it has some, else raw wrench with its triggers.
///
/// \throws std::runtime_error in one line that names the bag: no such file, not a bag, cut off, no WrenchStamped topic
/// or more than one, no episode in it.
BagContents ReadEpisodes(const std::string& path, const BagReaderOptions& options,
                         const ReadProgress& progress = nullptr);

/// ReadEpisodes() of several bags, one after the other. \throws std::runtime_error as it does, or where there is no
/// bag.
std::vector<core::Episode> ReadAllEpisodes(const std::vector<std::string>& paths, const BagReaderOptions& options,
                                           const ReadProgress& progress = nullptr);

}  // namespace contact_shapelets
