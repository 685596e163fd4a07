#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/core/episode.h"
#include "evaluation/partition_metrics.h"

/// \file
/// How well events agree with the outcomes that operators gave.

namespace contact_shapelets::cli {

/// The event of one episode, and the cluster that it is nearest to.
struct NamedEpisode {
  std::string event;        ///< core::Diagnosis::event
  int nearest_cluster = 0;  ///< whatever the event
};

/// Returns event and nearest cluster of each result.
std::vector<NamedEpisode> NamedEpisodes(const std::vector<core::Classification>& results);

/// Compares events with outcomes. Only episodes with an outcome count. An event is right if it equals the outcome, so
/// `unknown` is never right.
class EventScores {
 public:
  /// `named` has one item for each of `episodes`. \throws std::invalid_argument if the sizes differ.
  EventScores(const core::Model& model, const std::vector<core::Episode>& episodes,
              const std::vector<NamedEpisode>& named);

  /// Number of episodes with an outcome.
  int episodes() const { return episodes_; }
  /// Number of them with the right event.
  int right() const { return right_; }
  /// Number of them that are `unknown`.
  int unknown() const { return unknown_; }
  /// The outcomes, in alphabetical order: rows of the confusion table.
  const std::vector<std::string>& outcomes() const { return outcomes_; }
  /// The events, `unknown` last: columns of the confusion table. They include each outcome that names a cluster.
  const std::vector<std::string>& events() const { return events_; }
  /// Returns the number of episodes with this outcome and this event.
  int CountOf(const std::string& outcome, const std::string& event) const;
  /// Returns true if a cluster has this name.
  bool IsNamed(const std::string& name) const;

  /// Returns "events right: 134 of 159 (unknown 3)".
  std::string Summary() const;
  /// Returns one line for each name that may mislead: a cluster with more episodes of another outcome, an outcome that
  /// names no cluster, and a name of several clusters.
  std::vector<std::string> Warnings() const;
  /// Returns the indices of the clusters against the outcomes in one line; an empty string for fewer than two episodes.
  std::string Indices() const;

  /// Prints summary, confusion table, warnings and indices to stdout; nothing if no episode has an outcome.
  void Print() const;

 private:
  void AddMinorities(std::vector<std::string>* warnings) const;
  void PrintTable() const;

  int episodes_ = 0;
  int right_ = 0;
  int unknown_ = 0;
  std::vector<std::string> outcomes_;
  std::vector<std::string> events_;
  std::vector<std::string> names_;                               ///< the name of each cluster, empty if it has none
  std::map<std::string, std::map<std::string, int>> confusion_;  ///< by outcome and event
  std::vector<std::map<std::string, int>> in_cluster_;           ///< outcomes of the known episodes of each cluster
  std::optional<evaluation::OutcomeScores> indices_;
};

}  // namespace contact_shapelets::cli
