#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/episode_edge.h"
#include "contact_shapelets/core/segmentation_options.h"
#include "contact_shapelets/core/stream_summary.h"
#include "core/stream/contact_detector.h"
#include "core/stream/sample_buffer.h"
#include "core/stream/wrench_sample.h"

/// \file
/// Cuts a wrench stream into episodes. Only WrenchStream uses it.

namespace contact_shapelets::core {

/// An edge with its place among the samples.
struct PlacedEdge {
  EpisodeEdge edge;
  Nanoseconds by_stamp = 0;    ///< its time by its stamp
  Nanoseconds by_arrival = 0;  ///< its time by its arrival
  bool clock_is_off = false;   ///< the clock of its sender is not that of the samples
  Nanoseconds ahead = 0;       ///< time from its arrival to its time, if that is later
};

/// Cuts by the times of samples and edges. Waits on a second clock, that of arrivals. The callers pass its time as
/// `now`. It never goes back.
///
/// A closing edge waits for the samples before it, until `edge_wait` after its arrival or its time, whichever is later.
/// It waits longer while samples arrive, but by at most `stream_timeout`.
///
/// An unstamped and a stamped edge of one kind within `edge_match_window` are the same edge, and the stamp counts. A
/// stamped opening corrects an unstamped one. The unstamped closing of an episode with a stamped opening waits for the
/// stamped closing, for at most `edge_match_window`. Stamped edges from before the end of the last episode are echoes
/// and ignored.
class EpisodeSegmenter {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit EpisodeSegmenter(const SegmentationOptions& options);

  /// Takes the next sample of the stream.
  void AddSample(const WrenchSample& sample, Nanoseconds now);
  /// Takes an edge. In the mode SegmentationMode::kContact only commands count.
  void AddEdge(const PlacedEdge& placed, Nanoseconds now);
  /// Lets time pass without a sample, so that waits and timeouts run out.
  void AdvanceTo(Nanoseconds now);
  /// Returns the time at which the next wait or timeout runs out, if nothing arrives before.
  std::optional<Nanoseconds> NextDue() const;
  /// Starts anew with an empty buffer. An open episode ends with EndReason::kStream.
  void Restart(Nanoseconds now);
  /// Ends the input. Finishes the episodes that wait. An open episode ends with EndReason::kStream.
  void Finish(Nanoseconds now);

  /// Returns the mean force [N] of the last `tare_duration`. \throws std::runtime_error if there is no sample yet.
  Eigen::Vector3d MeasureTare() const;
  /// Sets the tare [N] of TareSource::kService.
  void set_tare(const Eigen::Vector3d& tare) { service_tare_ = tare; }

  /// Sets the sensor's frame, which becomes Episode::frame_id.
  void set_frame_id(const std::string& frame_id) { frame_id_ = frame_id; }
  /// Returns true while an episode is open.
  bool IsOpen() const { return !intervals_.empty() && !intervals_.back().closed; }
  /// Returns the open episode so far, marked as incomplete; nothing if no episode is open or it is shorter than
  /// `min_duration`.
  std::optional<Episode> OpenEpisode() const;
  /// Returns the episodes that were finished since the last call.
  std::vector<Episode> TakeEpisodes();
  /// Returns the edges that were decided since the last call.
  std::vector<EpisodeEdge> TakeEdges();
  /// Returns true if TakeEpisodes() or TakeEdges() would return something.
  bool HasNews() const { return !episodes_.empty() || !edges_.empty(); }
  /// Number of episodes with each fault so far.
  const EpisodeFaultCounts& fault_counts() const { return fault_counts_; }
  /// Number of openings that arrived while an episode was open.
  std::int64_t repeated_openings() const { return repeated_openings_; }
  /// Number of closings that arrived while no episode was open, without those that repeat the state of the trigger.
  std::int64_t lost_openings() const { return lost_openings_; }
  /// [s] time that the contact mode has been without a baseline; 0 in other modes.
  double without_baseline() const { return contact_.without_baseline(); }

 private:
  struct Interval {
    std::string id;
    EdgeSource source = EdgeSource::kUnstamped;  ///< of the opening
    Nanoseconds open = 0;
    Nanoseconds open_by_stamp = 0;
    Nanoseconds open_by_arrival = 0;
    Nanoseconds earliest = 0;  ///< the end of the episode before
    Nanoseconds opening_arrival = 0;
    Nanoseconds opened = 0;    ///< on the clock of arrivals
    Nanoseconds deadline = 0;  ///< on the clock of arrivals
    Nanoseconds close = 0;
    bool closed = false;
    bool awaits_stamp = false;  ///< a stamped closing may still correct the unstamped one
    EpisodeEdge closing;
    EndReason reason = EndReason::kUnknown;
    std::uint32_t faults = 0;  ///< one bit for each EpisodeFault
  };

  bool IsTwin(const EpisodeEdge& edge);
  bool IsStale(const EpisodeEdge& edge) const;
  bool TakeStamped(const PlacedEdge& placed, Nanoseconds now);
  void CorrectOpening(const PlacedEdge& placed);
  bool CorrectClosing(const PlacedEdge& placed, Nanoseconds now);
  void ProveOpening(const PlacedEdge& closing, Interval* interval);
  void Open(const PlacedEdge& placed, Nanoseconds now);
  void Close(const EpisodeEdge& closing, EndReason reason, Nanoseconds now, Nanoseconds ahead = 0);
  void EndByStream(Nanoseconds now, EpisodeFault fault);
  void FollowContact(const WrenchSample& sample, Nanoseconds now);
  Nanoseconds DeadlineOf(const Interval& interval) const;
  void FinishReady(Nanoseconds now);
  void Emit(Interval* interval);
  void Count(EpisodeFault fault) { ++fault_counts_[static_cast<std::size_t>(fault)]; }
  Eigen::Vector3d TareOf(const Interval& interval, const std::vector<WrenchSample>& samples) const;
  Episode Cut(const Interval& interval, const std::vector<WrenchSample>& samples) const;

  SegmentationOptions options_;
  Nanoseconds stream_timeout_;
  Nanoseconds max_duration_;
  ContactDetector contact_;
  SampleBuffer buffer_;
  std::deque<Interval> intervals_;
  std::vector<Episode> episodes_;
  std::vector<EpisodeEdge> edges_;
  std::string frame_id_;
  std::optional<Eigen::Vector3d> service_tare_;
  /// The last stamped closing [0] and opening [1] without an unstamped twin.
  std::array<std::optional<Nanoseconds>, 2> single_stamps_;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_close_ = std::numeric_limits<Nanoseconds>::min();
  EpisodeFaultCounts fault_counts_{};
  std::int64_t repeated_openings_ = 0;
  std::int64_t lost_openings_ = 0;
  Nanoseconds last_opening_ = 0;  ///< arrival of the last opening, a repeated one as well
  Nanoseconds last_closing_ = 0;  ///< arrival of the last closing, a repeated one as well
  bool closing_is_due_ = false;   ///< the last episode was cut before its closing came
};

}  // namespace contact_shapelets::core
