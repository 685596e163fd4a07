#include "core/drift/run_monitor.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace contact_shapelets::core {
namespace {

std::string Rounded(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string TextOf(const Change& change, const Model& model) {
  if (change.rate) {
    return change.what + " occurs " + (change.since > change.before ? "more" : "less") +
           " often: " + Rounded("%.1f %%", 100.0 * change.since) + " of the episodes, " +
           Rounded("%.1f %%", 100.0 * change.before) + " before";
  }
  const bool higher = change.since > change.before;
  return "the " + change.what + (change.group ? " of " + model.EventOf(*change.group) : "") + " is " +
         (higher ? "higher" : "lower") + " by " +
         Rounded("%.0f %%", 100.0 * std::abs(change.since / change.before - 1.0)) + ": " +
         Rounded("%.3g", change.since) + ", " + Rounded("%.3g", change.before) + " before";
}

}  // namespace

RunMonitor::RunMonitor(int reference, const ChangeOptions& options)
    : reference_(static_cast<std::size_t>(reference)), options_(options) {
  if (reference < 0) throw std::invalid_argument("expected a number of reference episodes that is not negative");
  // The monitor checks the options now, and not after the reference was gathered.
  const ChangeMonitor check({}, options);
}

void RunMonitor::Append(const Episode& episode, const Diagnosis& diagnosis, const Model& model) {
  seen_.push_back({episode.id, episode.start});
  const WatchedEpisode watched{diagnosis.nearest_cluster, TraitsOf(episode, diagnosis.novelty), diagnosis.event};
  if (!monitor_) {
    first_.push_back(watched);
    if (first_.size() >= reference_) monitor_.emplace(first_, options_);
    return;
  }
  monitor_->Append(watched);
  if (!monitor_->change() || change_) return;
  const Change& change = *monitor_->change();
  const auto index = first_.size() + static_cast<std::size_t>(change.first);
  change_ = RunChange{TextOf(change, model), seen_[index].id, seen_[index].start, static_cast<std::int64_t>(index)};
}

std::optional<double> RunMonitor::LogEvidence() const {
  if (!monitor_ || monitor_->count() == 0) return std::nullopt;
  return monitor_->LogEvidence();
}

}  // namespace contact_shapelets::core
