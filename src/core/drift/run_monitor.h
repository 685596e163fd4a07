#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/classifier.h"
#include "core/drift/change_monitor.h"

/// \file
/// Watches the episodes that a model diagnoses, for the classifier node and the offline program.

namespace contact_shapelets::core {

/// A change of the run, for people.
struct RunChange {
  std::string text;        ///< "the mean force is lower by 19 %: 8.10, 10.0 before"
  std::string episode;     ///< id of the likely first changed episode
  Nanoseconds start = 0;   ///< when that episode started
  std::int64_t index = 0;  ///< its number among the episodes of the run, from 0
};

/// Compares the episodes of a run with its first ones by a ChangeMonitor.
class RunMonitor {
 public:
  /// The first `reference` episodes are those that later ones are compared with.
  /// \throws std::invalid_argument if `reference` is negative or the probability is not in (0, 1).
  RunMonitor(int reference, const ChangeOptions& options);

  /// Takes the next episode and what `model` says of it.
  void Append(const Episode& episode, const Diagnosis& diagnosis, const Model& model);

  /// Returns the first change that was found; none if there is none so far.
  const std::optional<RunChange>& change() const { return change_; }

  /// Returns the natural logarithm of the evidence over what tells a change; none while the reference is gathered.
  std::optional<double> LogEvidence() const;

  std::int64_t count() const { return static_cast<std::int64_t>(seen_.size()); }  ///< episodes taken

 private:
  /// What a message needs of an episode.
  struct Seen {
    std::string id;
    Nanoseconds start = 0;
  };

  std::size_t reference_;
  ChangeOptions options_;
  std::vector<WatchedEpisode> first_;
  std::optional<ChangeMonitor> monitor_;
  std::vector<Seen> seen_;
  std::optional<RunChange> change_;
};

}  // namespace contact_shapelets::core
