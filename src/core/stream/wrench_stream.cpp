#include "contact_shapelets/core/wrench_stream.h"

#include "core/stream/episode_segmenter.h"
#include "core/stream/sample_clock.h"
#include "core/stream/stream_monitor.h"

namespace contact_shapelets::core {

struct WrenchStream::Parts {
  explicit Parts(const SegmentationOptions& options) : segmenter(options) {}

  void SetStamps(StreamMonitor* of) const {
    of->SetStamps(clock.zero_stamps(), clock.wrong_stamps(), ToSeconds(clock.offset()));
  }

  SampleClock clock;
  StreamMonitor monitor;
  EpisodeSegmenter segmenter;
};

WrenchStream::WrenchStream(const SegmentationOptions& options) : parts_(std::make_unique<Parts>(options)) {}
WrenchStream::~WrenchStream() = default;
WrenchStream::WrenchStream(WrenchStream&&) noexcept = default;
WrenchStream& WrenchStream::operator=(WrenchStream&&) noexcept = default;

bool WrenchStream::AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force) {
  auto& [clock, monitor, segmenter] = *parts_;
  if (!(force.norm() <= kGreatestForce)) {
    monitor.AddNotFinite();
    return false;
  }
  // A driver without news from its sensor may send the last message again.
  if (clock.IsLastStamp(stamp) && monitor.IsLastForce(force)) {
    monitor.AddRepeatedMessage(clock.FromArrival(arrival));
    return false;
  }
  const SampleTime sample = clock.Resolve(stamp, arrival);
  if (sample.verdict == SampleTime::Verdict::kOutOfOrder) {
    monitor.AddOutOfOrder();
    return false;
  }
  if (sample.verdict == SampleTime::Verdict::kJumpedBack) {
    monitor.JumpBack();
    segmenter.Restart();
  }
  monitor.AddSample(sample.time, force);
  segmenter.AddSample({sample.time, force}, clock.FromArrival(arrival));
  return true;
}

void WrenchStream::AddPlainEdge(bool open, Nanoseconds arrival) {
  const Nanoseconds time = parts_->clock.FromArrival(arrival);
  parts_->segmenter.AddEdge({open, time, EdgeSource::kPlain, ""}, time);
}

void WrenchStream::AddCommand(bool open, Nanoseconds arrival) {
  const Nanoseconds time = parts_->clock.FromArrival(arrival);
  parts_->segmenter.AddEdge({open, time, EdgeSource::kCommand, ""}, time);
}

void WrenchStream::AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival) {
  const Nanoseconds now = parts_->clock.FromArrival(arrival);
  // A publisher that forgot the stamp is as good as one that has none.
  parts_->segmenter.AddEdge(
      stamp == 0 ? EpisodeEdge{open, now, EdgeSource::kPlain, id} : EpisodeEdge{open, stamp, EdgeSource::kStamped, id},
      now);
}

void WrenchStream::AdvanceTo(Nanoseconds arrival) { parts_->segmenter.AdvanceTo(parts_->clock.FromArrival(arrival)); }

void WrenchStream::Finish() { parts_->segmenter.Finish(); }

Eigen::Vector3d WrenchStream::TareNow() { return parts_->segmenter.TareNow(); }

void WrenchStream::set_frame_id(const std::string& frame_id) { parts_->segmenter.set_frame_id(frame_id); }

bool WrenchStream::IsOpen() const { return parts_->segmenter.IsOpen(); }

std::optional<Episode> WrenchStream::OpenEpisode() const { return parts_->segmenter.OpenEpisode(); }

bool WrenchStream::HasNews() const { return parts_->segmenter.HasNews(); }

std::vector<Episode> WrenchStream::TakeEpisodes() { return parts_->segmenter.TakeEpisodes(); }

std::vector<EpisodeEdge> WrenchStream::TakeEdges() { return parts_->segmenter.TakeEdges(); }

int WrenchStream::dropped_episodes() const { return parts_->segmenter.dropped_episodes(); }

StreamSummary WrenchStream::Summary() const {
  StreamMonitor monitor = parts_->monitor;
  parts_->SetStamps(&monitor);
  return monitor.Summary();
}

StreamSummary WrenchStream::TakeLap() {
  parts_->SetStamps(&parts_->monitor);
  return parts_->monitor.TakeLap();
}

}  // namespace contact_shapelets::core
