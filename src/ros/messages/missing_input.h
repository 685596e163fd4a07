#pragma once

#include <functional>
#include <string>
#include <vector>

/// \file
/// Says what to do if a node that cuts episodes receives no wrench or no trigger.

namespace contact_shapelets {

/// What the node has received so far.
struct ReceivedInput {
  bool wrench = false;         ///< a wrench has come
  bool edge = false;           ///< an edge of any kind has come
  double waited = 0.0;         ///< [s] since the start or the last wrench
  double duration = 0.0;       ///< [s] from the first to the last wrench
  std::string wrench_topic;    ///< resolved name
  std::string trigger_topics;  ///< resolved names, as shown to the user; empty if contact opens the episodes
};

/// Returns what is missing and what to do: after 5 s without a first wrench, or after 60 s of wrenches without a
/// trigger. Returns an empty string if nothing is missing. Calls `other_wrenches` only for the first: it returns the
/// topics of the wrench's type that exist.
std::string MissingInput(const ReceivedInput& input, const std::function<std::vector<std::string>()>& other_wrenches);

}  // namespace contact_shapelets
