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
/// Cuts a wrench stream into episodes. WrenchStream drives it, and nothing else.

namespace contact_shapelets::core {

/// An edge with its place among the samples.
struct PlacedEdge {
  EpisodeEdge edge;
  Nanoseconds by_stamp = 0;    ///< where its stamp puts a stamped edge
  Nanoseconds by_arrival = 0;  ///< where its arrival puts it
  bool clock_is_off = false;   ///< the stamps of its sender are not on the clock of the samples
  Nanoseconds ahead = 0;       ///< how long after its arrival its time comes
};

/// Cuts by the times of samples and edges. All waiting is on a second clock, that of arrivals, which the calls' `now`
/// says and which never goes back.
///
/// A closing edge waits for the samples before it, but no longer than `edge_wait` after its arrival or its time,
/// whichever is later. A plain and a stamped edge of one kind within `edge_match_window` are the same edge, and the
/// stamp counts: a stamped opening corrects a plain one, and the plain closing of an episode that a stamped edge opened
/// waits so long for its stamped twin. Stamped edges from before the end of the last episode are echoes, and ignored.
class EpisodeSegmenter {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit EpisodeSegmenter(const SegmentationOptions& options);

  /// Takes the next sample of the stream. Does not allocate.
  void AddSample(const WrenchSample& sample, Nanoseconds now);
  /// Takes an edge; for contact segmentation only commands count.
  void AddEdge(const PlacedEdge& placed, Nanoseconds now);
  /// Lets time pass without a sample: waits and timeouts run out.
  void AdvanceTo(Nanoseconds now);
  /// When the next wait or timeout runs out, if nothing arrives before.
  std::optional<Nanoseconds> NextDue() const;
  /// Time began anew: an open episode ends with EndReason::kStream, and the buffer is emptied.
  void Restart(Nanoseconds now);
  /// Ends the input: what is closed but waits is finished; what is open ends with EndReason::kStream.
  void Finish(Nanoseconds now);

  /// The mean force of the last `tare_duration` [N]. \throws std::runtime_error if there was no sample yet.
  Eigen::Vector3d MeasureTare() const;
  /// Sets the tare [N] of TareSource::kService.
  void set_tare(const Eigen::Vector3d& tare) { service_tare_ = tare; }

  /// Sets the sensor's frame, which episodes carry.
  void set_frame_id(const std::string& frame_id) { frame_id_ = frame_id; }
  /// True while an episode is open.
  bool IsOpen() const { return !intervals_.empty() && !intervals_.back().closed; }
  /// The open episode so far, incomplete; none if no episode is open or it is shorter than `min_duration`.
  std::optional<Episode> OpenEpisode() const;
  /// The episodes that were finished since the last call.
  std::vector<Episode> TakeEpisodes();
  /// The edges that were decided since the last call.
  std::vector<EpisodeEdge> TakeEdges();
  /// True if TakeEpisodes() or TakeEdges() would return something.
  bool HasNews() const { return !episodes_.empty() || !edges_.empty(); }
  /// Episodes with each fault so far.
  const EpisodeFaultCounts& fault_counts() const { return fault_counts_; }
  /// Openings that arrived while an episode was open.
  std::int64_t repeated_openings() const { return repeated_openings_; }

 private:
  struct Interval {
    std::string id;
    EdgeSource source = EdgeSource::kPlain;  ///< of the opening
    Nanoseconds open = 0;
    Nanoseconds open_by_stamp = 0;
    Nanoseconds open_by_arrival = 0;
    Nanoseconds earliest = 0;  ///< the end of the one before
    Nanoseconds opening_arrival = 0;
    Nanoseconds opened = 0;  ///< on the clock of arrivals, as the next
    Nanoseconds deadline = 0;
    Nanoseconds close = 0;
    bool closed = false;
    bool awaits_stamp = false;  ///< a stamped closing may still correct a plain one
    EpisodeEdge closing;
    EndReason reason = EndReason::kUnknown;
    std::uint32_t faults = 0;  ///< a bit for each EpisodeFault
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
  /// The last stamped closing [0] and opening [1] that no plain edge was the twin of.
  std::array<std::optional<Nanoseconds>, 2> single_stamps_;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_close_ = std::numeric_limits<Nanoseconds>::min();
  EpisodeFaultCounts fault_counts_{};
  std::int64_t repeated_openings_ = 0;
};

}  // namespace contact_shapelets::core
