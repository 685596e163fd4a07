#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/episode_edge.h"
#include "contact_shapelets/core/segmentation_options.h"
#include "contact_shapelets/core/stream_summary.h"

/// \file
/// From wrenches and edges to episodes: clock, health, segmentation. The episode node feeds it from subscribers, the
/// reader of bags from files, with the same calls, so that both give the same episodes.

namespace contact_shapelets::core {

/// One sensor's stream with its triggers. An arrival is the time of a message's receipt, which a bag records.
///
/// All order and all waiting is by arrivals. A wrench has a time by its stamp, and an edge keeps its own clock until it
/// gets its place among the wrenches: after the next wrench, and once the relation of the two clocks is known. How
/// often AdvanceTo() is called makes no difference to what comes out, only to when.
class WrenchStream {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit WrenchStream(const SegmentationOptions& options);
  ~WrenchStream();
  WrenchStream(WrenchStream&&) noexcept;
  WrenchStream& operator=(WrenchStream&&) noexcept;

  /// Takes a wrench with the header's `stamp` (0: none). Counts and drops forces that are not finite or above
  /// kGreatestForce. Returns false if it dropped the sample.
  bool AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force);
  /// Takes an edge without a stamp, at its `arrival`. Ignores edges that change nothing.
  void AddPlainEdge(bool open, Nanoseconds arrival, const std::string& id = "");
  /// Takes a service call at `arrival`.
  void AddCommand(bool open, Nanoseconds arrival);
  /// Takes an edge with a `stamp` on the clock of the wrench; a stamp of 0 counts as none. The stamps of a `sender`
  /// whose edges are all too late or too early alike are on another clock: the arrivals of its edges count.
  void AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival,
                      const std::string& sender = "");
  /// Takes the status of an action: a goal is `active` or not. A change is a plain edge.
  void AddStatus(bool active, Nanoseconds arrival);
  /// Lets time pass without a wrench: waits and timeouts run out.
  void AdvanceTo(Nanoseconds arrival);
  /// Ends the input: finishes the episodes that wait; an open one ends with EndReason::kStream.
  void Finish();

  /// Takes the mean force of the last `tare_duration` as the tare of TareSource::kService and returns it [N].
  /// \throws std::runtime_error if no wrench has arrived yet.
  Eigen::Vector3d TareNow();
  /// Sets the tare [N] of TareSource::kService, as it was measured before.
  void SetTare(const Eigen::Vector3d& tare);
  /// Time of the last wrench, on the clock of the stamps.
  Nanoseconds last_wrench() const;

  /// Says who sends the wrenches that follow. Two that take turns are a finding.
  void SetPublisher(const std::string& name);
  /// Sets the sensor's frame, which episodes carry.
  void set_frame_id(const std::string& frame_id);
  /// True while an episode is open, or about to be.
  bool IsOpen() const;
  /// The open episode so far, incomplete; none if no episode is open or it is shorter than `min_duration`.
  std::optional<Episode> OpenEpisode() const;
  /// True if TakeEpisodes() or TakeEdges() would return something.
  bool HasNews() const;
  /// The episodes that ended since the last call, in the order of their ends.
  std::vector<Episode> TakeEpisodes();
  /// The edges decided on since the last call, in order.
  std::vector<EpisodeEdge> TakeEdges();

  /// The health of the whole stream and of its episodes.
  StreamSummary Summary() const;
  /// The same since the last call, or since the start.
  StreamSummary TakeLap();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace contact_shapelets::core
