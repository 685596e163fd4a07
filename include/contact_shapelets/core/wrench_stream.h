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
/// Turns wrenches and edges into episodes: clock, health, segmentation. The episode node feeds it from subscribers, the
/// bag reader from files. Both make the same calls and get the same episodes.

namespace contact_shapelets::core {

/// The stream of one sensor with its triggers. An arrival is the time at which a message is received. Bags record it.
///
/// Arrivals decide the order and all waiting. The stamp of a wrench decides its time. An edge gets its place among the
/// wrenches after the next wrench, and not before the relation of the two clocks is known. Frequent calls of
/// AdvanceTo() make results come earlier, but do not change them.
class WrenchStream {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit WrenchStream(const SegmentationOptions& options);
  ~WrenchStream();
  /// Takes over the stream of another object, which must not be used afterwards.
  WrenchStream(WrenchStream&&) noexcept;
  /// Takes over the stream of another object, which must not be used afterwards.
  WrenchStream& operator=(WrenchStream&&) noexcept;

  /// Takes the `force` [N] of a wrench with the header's `stamp` (0: none). Drops and counts samples that are not
  /// finite, above kGreatestForce, repeated with their stamp or out of order. Returns false if it dropped the sample.
  bool AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force);
  /// Takes an edge without a stamp, at its `arrival`. Ignores edges that change nothing.
  void AddUnstampedEdge(bool open, Nanoseconds arrival, const std::string& id = "");
  /// Takes a service call at `arrival`.
  void AddCommand(bool open, Nanoseconds arrival);
  /// Takes an edge with a `stamp` on the clock of the wrench. A stamp of 0 makes it an unstamped edge. If the edges of
  /// a `sender` are too late or too early by the same amount, its clock is off, and their arrivals count.
  void AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival,
                      const std::string& sender = "");
  /// Takes the status of an action: a goal is `active` or not. A change counts as an unstamped edge.
  void AddStatus(bool active, Nanoseconds arrival);
  /// Lets time pass without a wrench, so that waits and timeouts run out.
  void AdvanceTo(Nanoseconds arrival);
  /// Ends the input. Finishes the episodes that wait. An open episode ends with EndReason::kStream.
  void Finish();

  /// Sets the tare of TareSource::kService to the mean force of the last `tare_duration`. Returns it [N].
  /// \throws std::runtime_error if no wrench has arrived yet.
  Eigen::Vector3d TareNow();
  /// Sets the tare [N] of TareSource::kService to one that was measured earlier.
  void SetTare(const Eigen::Vector3d& tare);
  /// Returns the time of the last wrench, on the clock of the stamps.
  Nanoseconds last_wrench() const;

  /// Sets the publisher of the wrenches that follow. Two publishers that take turns are a finding.
  void SetPublisher(const std::string& name);
  /// Sets the sensor's frame, which becomes Episode::frame_id.
  void set_frame_id(const std::string& frame_id);
  /// Returns true while an episode is open or a waiting edge will open one.
  bool IsOpen() const;
  /// Returns the open episode so far, marked as incomplete; nothing if no episode is open or it is shorter than
  /// `min_duration`.
  std::optional<Episode> OpenEpisode() const;
  /// Returns true if TakeEpisodes() or TakeEdges() would return something.
  bool HasNews() const;
  /// Returns the episodes that ended since the last call, in the order of their ends.
  std::vector<Episode> TakeEpisodes();
  /// Returns the edges that were decided since the last call, in order. A later edge may correct an earlier one.
  std::vector<EpisodeEdge> TakeEdges();

  /// Returns the health of the whole stream and of its episodes.
  StreamSummary Summary() const;
  /// Returns the health since the last call, or since the start.
  StreamSummary TakeLap();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace contact_shapelets::core
