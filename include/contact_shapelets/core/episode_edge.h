#pragma once

#include <string>

#include "contact_shapelets/core/time.h"

namespace contact_shapelets::core {

/// Where an edge comes from.
enum class EdgeSource {
  kUnstamped,  ///< a message without a stamp: its time is that of its arrival
  kStamped,    ///< a message with a stamp: exact, replaces an unstamped message for the same edge
  kCommand,    ///< a service call
  kContact,    ///< the contact force
};

/// The opening or closing of an episode.
struct EpisodeEdge {
  bool open = true;                            ///< true for an opening, false for a closing
  Nanoseconds time = 0;                        ///< on the clock of the samples
  EdgeSource source = EdgeSource::kUnstamped;  ///< where it comes from
  std::string id;                              ///< id of the episode; may be empty
  Nanoseconds arrival = 0;  ///< when it arrived, on the clock of arrivals; for contact, when the force fell
};

}  // namespace contact_shapelets::core
