#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/episode_edge.h"
#include "contact_shapelets/core/segmentation_options.h"
#include "core/stream/contact_detector.h"
#include "core/stream/wrench_sample.h"

/// \file
/// Cuts a wrench stream into episodes. Used alike by the episode node and by the reader of bags.

namespace contact_shapelets::core {

/// Cuts by time, not by order of arrival: a closing edge waits for the samples before it, but no longer than
/// `edge_wait` after its arrival or its time, whichever is later.
///
/// Once a stamped edge was seen, plain ones are ignored, so that a bag that holds both gives each episode once. A
/// stamped opening within `edge_match_window` of the open episode's corrects that. Stamped edges from before the end of
/// the last episode are echoes of edges that were seen, and ignored. A stamp that is more than `stream_timeout` ahead
/// of its arrival, or further back than an episode may last, is wrong: its arrival counts.
class EpisodeSegmenter {
 public:
  /// \throws std::invalid_argument naming every parameter that is out of range.
  explicit EpisodeSegmenter(const SegmentationOptions& options);

  /// Takes the next sample of the stream; `now` is its arrival on the samples' clock. Does not allocate.
  void AddSample(const WrenchSample& sample, Nanoseconds now);
  /// Takes an edge that arrived at `now`; for contact segmentation only commands count.
  void AddEdge(const EpisodeEdge& arrived, Nanoseconds now);
  /// Lets time pass without a sample: waits and timeouts run out.
  void AdvanceTo(Nanoseconds now);
  /// Time began anew: an open episode ends with EndReason::kStream, and the buffer is emptied.
  void Restart();
  /// Ends the input: what is closed but waits is finished; what is open ends with EndReason::kStream.
  void Finish();

  /// Takes the mean force of the last `tare_duration` as the tare of TareSource::kService and returns it [N].
  /// \throws std::runtime_error where there was no sample yet.
  Eigen::Vector3d TareNow();

  /// Sets the sensor's frame, which episodes carry.
  void set_frame_id(const std::string& frame_id) { frame_id_ = frame_id; }
  /// True while an episode is open.
  bool IsOpen() const { return !intervals_.empty() && !intervals_.back().closed; }
  /// The open episode so far, incomplete; none where there is none or it is shorter than `min_duration`.
  std::optional<Episode> OpenEpisode() const;
  /// The episodes that were finished since the last call.
  std::vector<Episode> TakeEpisodes();
  /// The edges that were decided since the last call.
  std::vector<EpisodeEdge> TakeEdges();
  /// True where TakeEpisodes() or TakeEdges() would return something.
  bool HasNews() const { return !episodes_.empty() || !edges_.empty(); }
  /// Episodes that were dropped since they were shorter than `min_duration` or held no sample.
  int dropped_episodes() const { return dropped_episodes_; }

 private:
  struct Interval {
    std::string id;
    Nanoseconds open = 0;
    Nanoseconds close = 0;
    Nanoseconds deadline = 0;
    bool closed = false;
    EndReason reason = EndReason::kUnknown;
  };

  /// The last samples, oldest first; old ones are overwritten.
  class Buffer {
   public:
    explicit Buffer(std::size_t capacity) : samples_(capacity) {}
    void Add(const WrenchSample& sample);
    void Clear() { size_ = 0; }
    bool empty() const { return size_ == 0; }
    const WrenchSample& back() const { return (*this)[size_ - 1]; }
    std::vector<WrenchSample> Between(Nanoseconds begin, Nanoseconds end) const;

   private:
    const WrenchSample& operator[](std::size_t index) const { return samples_[(first_ + index) % samples_.size()]; }
    std::vector<WrenchSample> samples_;
    std::size_t first_ = 0;
    std::size_t size_ = 0;
  };

  bool IsStale(const EpisodeEdge& edge) const;
  void CorrectOpening(const EpisodeEdge& edge);
  void Open(const EpisodeEdge& edge);
  void Close(Nanoseconds time, EndReason reason, Nanoseconds now);
  void EndIfPaused(Nanoseconds last, Nanoseconds next, Nanoseconds now);
  void FinishReady(Nanoseconds now);
  void Emit(const Interval& interval);
  Eigen::Vector3d TareOf(const Interval& interval, const std::vector<WrenchSample>& samples) const;
  Episode Cut(const Interval& interval, const std::vector<WrenchSample>& samples) const;
  bool HasGap(const Interval& interval, const std::vector<WrenchSample>& samples) const;

  SegmentationOptions options_;
  ContactDetector contact_;
  Buffer buffer_;
  std::deque<Interval> intervals_;
  std::vector<Episode> episodes_;
  std::vector<EpisodeEdge> edges_;
  std::string frame_id_;
  Eigen::Vector3d service_tare_ = Eigen::Vector3d::Zero();
  bool stamped_seen_ = false;
  Nanoseconds last_arrival_ = 0;
  Nanoseconds last_close_ = std::numeric_limits<Nanoseconds>::min();
  int dropped_episodes_ = 0;
};

}  // namespace contact_shapelets::core
