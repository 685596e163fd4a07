#pragma once

#include <string>

#include "contact_shapelets/core/time.h"

namespace contact_shapelets::core {

/// Where an edge comes from.
enum class EdgeSource {
  kPlain,    ///< a message without a stamp: its time is that of its arrival
  kStamped,  ///< a message with a stamp: exact, replaces a plain one for the same edge
  kCommand,  ///< a service call
  kContact,  ///< the contact force
};

/// The opening or closing of an episode.
struct EpisodeEdge {
  bool open = true;                        ///< opening or closing
  Nanoseconds time = 0;                    ///< on the clock of the samples
  EdgeSource source = EdgeSource::kPlain;  ///< where it comes from
  std::string id;                          ///< of the episode; may be empty
  Nanoseconds arrival = 0;  ///< when it became known, on the clock of arrivals; for contact: when the force fell
};

}  // namespace contact_shapelets::core
