#include "contact_shapelets/core/wrench_stream.h"

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets::core {

bool WrenchStream::AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force) {
  if (!(force.norm() <= kGreatestForce)) {
    monitor_.AddNotFinite();
    return false;
  }
  // A driver without news from its sensor may send the last message again.
  if (clock_.IsLastStamp(stamp) && monitor_.IsLastForce(force)) {
    monitor_.AddRepeatedMessage(clock_.FromArrival(arrival));
    return false;
  }
  const SampleTime sample = clock_.Resolve(stamp, arrival);
  if (sample.verdict == SampleTime::Verdict::kOutOfOrder) {
    monitor_.AddOutOfOrder();
    return false;
  }
  if (sample.verdict == SampleTime::Verdict::kJumpedBack) {
    monitor_.JumpBack();
    segmenter_.Restart();
  }
  monitor_.AddSample(sample.time, force);
  segmenter_.AddSample({sample.time, force}, clock_.FromArrival(arrival));
  return true;
}

void WrenchStream::AddPlainEdge(bool open, Nanoseconds arrival) {
  const Nanoseconds time = clock_.FromArrival(arrival);
  segmenter_.AddEdge({open, time, EdgeSource::kPlain, ""}, time);
}

void WrenchStream::AddCommand(bool open, Nanoseconds arrival) {
  const Nanoseconds time = clock_.FromArrival(arrival);
  segmenter_.AddEdge({open, time, EdgeSource::kCommand, ""}, time);
}

void WrenchStream::AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival) {
  const Nanoseconds now = clock_.FromArrival(arrival);
  // A publisher that forgot the stamp is as good as one that has none.
  segmenter_.AddEdge(
      stamp == 0 ? EpisodeEdge{open, now, EdgeSource::kPlain, id} : EpisodeEdge{open, stamp, EdgeSource::kStamped, id},
      now);
}

StreamSummary WrenchStream::Summary() const {
  StreamMonitor monitor = monitor_;
  SetStamps(&monitor);
  return monitor.Summary();
}

StreamSummary WrenchStream::TakeLap() {
  SetStamps(&monitor_);
  return monitor_.TakeLap();
}

void WrenchStream::SetStamps(StreamMonitor* monitor) const {
  monitor->SetStamps(clock_.zero_stamps(), clock_.wrong_stamps(), 1e-9 * static_cast<double>(clock_.offset()));
}

}  // namespace contact_shapelets::core
