#pragma once

#include <Eigen/Core>
#include <string>

#include "contact_shapelets/core/episode_segmenter.h"
#include "contact_shapelets/core/sample_clock.h"
#include "contact_shapelets/core/stream_monitor.h"

/// \file
/// All that happens to a wrench stream before the classifier: clock, health, segmentation. The episode node feeds it
/// from subscribers, the reader of bags from files, so that both give the same episodes.

namespace contact_shapelets::core {

/// One sensor's stream with its triggers. Arrivals are times of receipt, which a bag records.
class WrenchStream {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit WrenchStream(const SegmentationOptions& options) : segmenter_(options) {}

  /// Takes a wrench with the header's `stamp` (0: none). Forces that are not finite or above kGreatestForce are counted
  /// and dropped. Returns false where the sample was dropped.
  bool AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force);
  /// Takes an edge without a stamp of its own, at its `arrival`. Edges that change nothing are ignored.
  void AddPlainEdge(bool open, Nanoseconds arrival);
  /// Takes a service call at `arrival`.
  void AddCommand(bool open, Nanoseconds arrival);
  /// Takes an edge with a `stamp` on the clock of the wrench; one with a stamp of 0 counts as one without.
  void AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival);
  /// Lets time pass.
  void AdvanceTo(Nanoseconds arrival) { segmenter_.AdvanceTo(clock_.FromArrival(arrival)); }

  /// The segmenter, which holds the results.
  EpisodeSegmenter& segmenter() { return segmenter_; }
  /// The segmenter, which holds the results.
  const EpisodeSegmenter& segmenter() const { return segmenter_; }
  /// The health of the whole stream.
  StreamSummary Summary() const;
  /// The health of the stream since the last call, or since the start.
  StreamSummary TakeLap();

 private:
  void SetStamps(StreamMonitor* monitor) const;

  SampleClock clock_;
  StreamMonitor monitor_;
  EpisodeSegmenter segmenter_;
};

}  // namespace contact_shapelets::core
