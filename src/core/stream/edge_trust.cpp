#include "core/stream/edge_trust.h"

#include <cstdlib>

namespace contact_shapelets::core {
namespace {

constexpr Nanoseconds kEarliest = -20'000'000;
constexpr Nanoseconds kLatest = 100'000'000;
/// Latenesses of edges by one clock differ by at most this.
constexpr Nanoseconds kAlike = 50'000'000;
/// Limits the memory for senders that come and go.
constexpr std::size_t kSenders = 100;

}  // namespace

bool EdgeTrust::IsClockOff(const std::string& sender, Nanoseconds lateness, Nanoseconds longest) {
  if (last_lateness_.size() >= kSenders) last_lateness_.clear();
  const auto last = last_lateness_.find(sender);
  const bool alike = last != last_lateness_.end() && std::abs(lateness - last->second) <= kAlike;
  last_lateness_[sender] = lateness;
  if (std::abs(lateness) > longest) return true;
  return alike && (lateness < kEarliest || lateness > kLatest);
}

}  // namespace contact_shapelets::core
