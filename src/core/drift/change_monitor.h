#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "core/drift/value_watch.h"
#include "core/numerics/random.h"

/// \file
/// Watches a run of episodes for a change of the application: forces, durations, or how often each event occurs.

namespace contact_shapelets::core {

/// What is watched of an episode. All are logarithms, so that a change is a factor.
enum class Trait { kMeanForce, kGreatestForce, kForceDeviation, kDuration, kNovelty };

constexpr std::size_t kTraits = 5;
using Traits = std::array<double, kTraits>;  ///< by Trait; one that is not a number is unknown and is not watched

/// Returns the trait's name for people: "mean force".
std::string NameOf(Trait trait);

/// Returns the logarithms of the traits of an episode [N, s]. Forces under 1 mN count as 1 mN, a novelty under 0.001 as
/// 0.001.
Traits TraitsOf(const Episode& episode, double novelty);

/// One episode as the monitor sees it.
struct WatchedEpisode {
  int group = 0;      ///< its cluster, or the nearest one if it fits none; at least 0
  Traits traits{};    ///< see TraitsOf()
  std::string event;  ///< what it was diagnosed as
};

/// A change that was found.
struct Change {
  std::string what;          ///< "mean force" and so on, or the event whose rate changed
  bool rate = false;         ///< true if `what` is an event
  std::optional<int> group;  ///< the cluster that changed; none if all did, and for a rate
  double before = 0.0;       ///< median before [N, s], or rate [0, 1]; that of the training if nothing came before
  double since = 0.0;        ///< median since then, or rate
  std::int64_t first = 0;    ///< index of the first changed episode of those appended, from 0; an estimate
};

/// Options of the monitor.
struct ChangeOptions {
  double false_alarm_probability = 0.05;  ///< (0, 1), of ever telling a change where there is none
  std::uint64_t seed = 1;                 ///< of the numbers that break ties
};

/// Tells at most one change. The probability of telling one although episodes are exchangeable with those of the
/// training is at most `false_alarm_probability`, however many episodes come: each of the values watched has a share
/// of it. It needs some 100 bytes of memory per episode.
class ChangeMonitor {
 public:
  /// `training` are the episodes of the training, by which new ones are judged. The monitor watches the groups and the
  /// rates of the events that they name, and that of "unknown"; it compares rates among new episodes alone, because
  /// what is trained on is seldom a fair sample.
  /// \throws std::invalid_argument if `false_alarm_probability` is not in (0, 1).
  ChangeMonitor(const std::vector<WatchedEpisode>& training, const ChangeOptions& options);

  /// Takes the next episode. One of a group that the training lacks counts for the rates of events alone.
  void Append(const WatchedEpisode& episode);

  /// Returns the change, as it was found first; none if there is none so far.
  const std::optional<Change>& change() const { return change_; }

  /// Returns the natural logarithm of the greatest evidence over what tells a change: above 0 one is told.
  double LogEvidence() const { return log_evidence_; }

  std::int64_t count() const { return static_cast<std::int64_t>(episodes_.size()); }  ///< episodes appended

 private:
  /// The values of one group, or of all.
  struct Watched {
    std::vector<ValueWatch> traits;                           ///< by Trait
    std::array<std::vector<std::int64_t>, kTraits> episodes;  ///< by Trait: index of each episode that was appended
  };

  /// Gives the values to the watches of `watched`, and tells a change.
  void Watch(std::optional<int> group, const Traits& values, Watched* watched);
  void WatchRates(const std::string& event);
  /// Returns true if `martingale` is the first to tell a change. Each of `watches` values has an equal part of a third
  /// of the false alarm probability.
  bool Tells(const PowerMartingale& martingale, std::size_t watches);
  Change TraitChange(std::optional<int> group, std::size_t trait, std::int64_t first) const;
  Change RateChange(const std::string& event, std::int64_t first) const;

  ChangeOptions options_;
  Random random_;
  std::map<int, std::vector<Traits>> training_;  ///< by group
  std::map<int, Traits> medians_;                ///< of the training, by group
  std::map<int, Watched> groups_;
  Watched all_;
  std::map<std::string, ValueWatch> rates_;
  std::vector<WatchedEpisode> episodes_;
  double log_evidence_ = 0.0;
  std::optional<Change> change_;
};

}  // namespace contact_shapelets::core
