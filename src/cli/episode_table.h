#pragma once

#include <ostream>
#include <vector>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/core/episode.h"

/// \file
/// Classified episodes as a table.

namespace contact_shapelets::cli {

/// Classifies `episodes` on `threads` threads (0: one per core). \throws std::invalid_argument naming an episode that
/// cannot be classified.
std::vector<core::Classification> ClassifyAll(const core::Classifier& classifier,
                                              const std::vector<core::Episode>& episodes, int threads);

/// The text that each table begins with.
constexpr char kTableStart[] = "episode_id,start,duration,samples,outcome,cluster,event,confidence,novelty";

/// Writes to `file` one line per episode: episode_id, start [s], duration [s], samples, outcome, cluster, event,
/// confidence, novelty, then the distance to every shapelet, d0 to dK-1. Quotes texts with commas, quotes or line
/// breaks (RFC 4180).
void WriteCsv(const std::vector<core::Episode>& episodes, const std::vector<core::Classification>& results,
              std::ostream* file);

}  // namespace contact_shapelets::cli
