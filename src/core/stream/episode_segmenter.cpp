#include "core/stream/episode_segmenter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/stream/resampler.h"

namespace contact_shapelets::core {
namespace {

constexpr double kGreatestRate = 2000.0;

std::size_t BufferCapacity(const SegmentationOptions& options) {
  const double before = std::max(options.tare_duration, options.pre_trigger + options.contact_hold_on);
  return static_cast<std::size_t>((options.max_duration + before + options.stream_timeout + 1.0) * kGreatestRate);
}

SegmentationOptions Checked(const SegmentationOptions& options) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
  return options;
}

/// The time of an episode's start names it within a recording, the same in a replay.
std::string NameByTime(Nanoseconds time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%lld.%03lld", static_cast<long long>(time / 1'000'000'000),
                static_cast<long long>(time / 1'000'000 % 1000));
  return text;
}

}  // namespace

void EpisodeSegmenter::Buffer::Add(const WrenchSample& sample) {
  if (size_ < samples_.size()) {
    samples_[(first_ + size_) % samples_.size()] = sample;
    ++size_;
  } else {
    samples_[first_] = sample;
    first_ = (first_ + 1) % samples_.size();
  }
}

std::vector<WrenchSample> EpisodeSegmenter::Buffer::Between(Nanoseconds begin, Nanoseconds end) const {
  std::size_t low = size_;
  while (low > 0 && (*this)[low - 1].time >= begin) --low;
  std::vector<WrenchSample> between;
  for (; low < size_ && (*this)[low].time <= end; ++low) between.push_back((*this)[low]);
  return between;
}

EpisodeSegmenter::EpisodeSegmenter(const SegmentationOptions& options)
    : options_(Checked(options)), contact_(options_), buffer_(BufferCapacity(options_)) {}

void EpisodeSegmenter::AddSample(const WrenchSample& sample, Nanoseconds now) {
  // A stream that paused for long ends the episode before its next sample counts. It paused by its own times alone: the
  // backlog of a busy machine arrives late, but whole.
  if (!buffer_.empty()) EndIfPaused(buffer_.back().time, sample.time, now);
  buffer_.Add(sample);
  last_arrival_ = now;
  if (options_.segmentation == Segmentation::kContact) {
    const std::optional<ContactDetector::Change> change = contact_.AddSample(sample);
    // Two contacts close to each other share no sample, or the first would be in the tare of the second.
    if (change && change->contact && !IsOpen()) {
      Open({true, std::max(change->time, last_close_), EdgeSource::kContact, ""});
    }
    if (change && !change->contact) Close(change->time, EndReason::kContact, now);
  }
  if (IsOpen() && sample.time - intervals_.back().open >= FromSeconds(options_.max_duration)) {
    Close(intervals_.back().open + FromSeconds(options_.max_duration), EndReason::kTimeout, now);
  }
  FinishReady(now);
}

void EpisodeSegmenter::AddEdge(const EpisodeEdge& arrived, Nanoseconds now) {
  if (options_.segmentation == Segmentation::kContact && arrived.source != EdgeSource::kCommand) return;
  if (arrived.source == EdgeSource::kPlain && stamped_seen_) return;
  EpisodeEdge edge = arrived;
  // Such a stamp comes from another clock: no sample has a time near it.
  const bool wrong_stamp = edge.time > now + FromSeconds(options_.stream_timeout) ||
                           edge.time < now - FromSeconds(options_.max_duration + options_.stream_timeout);
  if (wrong_stamp && last_arrival_ > 0) edge.time = now;
  if (edge.source == EdgeSource::kStamped) {
    stamped_seen_ = true;
    if (IsStale(edge)) return;
    if (edge.open && IsOpen()) CorrectOpening(edge);
  }
  if (edge.open && !IsOpen()) Open(edge);
  if (!edge.open) Close(edge.time, EndReason::kTrigger, now);
  FinishReady(now);
}

void EpisodeSegmenter::AdvanceTo(Nanoseconds now) {
  if (!buffer_.empty() && last_arrival_ > 0) EndIfPaused(last_arrival_, now, now);
  FinishReady(now);
}

void EpisodeSegmenter::EndIfPaused(Nanoseconds last, Nanoseconds next, Nanoseconds now) {
  if (!IsOpen() || next - std::max(last, intervals_.back().open) <= FromSeconds(options_.stream_timeout)) return;
  Close(std::max(buffer_.back().time, intervals_.back().open), EndReason::kStream, now);
  FinishReady(now);
}

void EpisodeSegmenter::Restart() {
  Finish();
  buffer_.Clear();
  contact_ = ContactDetector(options_);
  stamped_seen_ = false;
  last_arrival_ = 0;
  last_close_ = std::numeric_limits<Nanoseconds>::min();
}

void EpisodeSegmenter::Finish() {
  if (IsOpen()) {
    const Nanoseconds last = buffer_.empty() ? intervals_.back().open : buffer_.back().time;
    Close(std::max(last, intervals_.back().open), EndReason::kStream, last);
  }
  for (const Interval& interval : intervals_) Emit(interval);
  intervals_.clear();
}

Eigen::Vector3d EpisodeSegmenter::TareNow() {
  if (buffer_.empty()) throw std::runtime_error("no wrench has arrived yet: there is nothing to tare");
  const Nanoseconds end = buffer_.back().time;
  service_tare_ = MeanForce(buffer_.Between(end - FromSeconds(options_.tare_duration), end),
                            end - FromSeconds(options_.tare_duration), end);
  return service_tare_;
}

std::optional<Episode> EpisodeSegmenter::OpenEpisode() const {
  if (!IsOpen() || buffer_.empty()) return std::nullopt;
  Interval so_far = intervals_.back();
  so_far.close = buffer_.back().time;
  if (so_far.close - so_far.open < FromSeconds(options_.min_duration)) return std::nullopt;
  const std::vector<WrenchSample> samples = buffer_.Between(so_far.open, so_far.close);
  if (samples.empty()) return std::nullopt;
  Episode episode = Cut(so_far, samples);
  episode.complete = false;
  return episode;
}

std::vector<Episode> EpisodeSegmenter::TakeEpisodes() { return std::exchange(episodes_, {}); }

std::vector<EpisodeEdge> EpisodeSegmenter::TakeEdges() { return std::exchange(edges_, {}); }

bool EpisodeSegmenter::IsStale(const EpisodeEdge& edge) const {
  return edge.open ? !IsOpen() && edge.time < last_close_ : edge.time <= last_close_;
}

void EpisodeSegmenter::CorrectOpening(const EpisodeEdge& edge) {
  Interval& interval = intervals_.back();
  const Nanoseconds difference = std::abs(edge.time - interval.open);
  if (difference == 0 || difference > FromSeconds(options_.edge_match_window) || edge.time < last_close_) return;
  interval.open = edge.time;
  interval.id = edge.id.empty() ? NameByTime(edge.time) : edge.id;
  edges_.push_back({true, edge.time, edge.source, interval.id});
}

void EpisodeSegmenter::Open(const EpisodeEdge& edge) {
  Interval interval;
  interval.id = edge.id.empty() ? NameByTime(edge.time) : edge.id;
  interval.open = edge.time;
  intervals_.push_back(interval);
  edges_.push_back({true, edge.time, edge.source, interval.id});
}

void EpisodeSegmenter::Close(Nanoseconds time, EndReason reason, Nanoseconds now) {
  if (!IsOpen()) return;
  Interval& interval = intervals_.back();
  interval.closed = true;
  interval.close = std::clamp(time, interval.open, interval.open + FromSeconds(options_.max_duration));
  // An edge that is stamped ahead of its arrival waits for the samples up to its stamp.
  interval.deadline = std::max(now, interval.close) + FromSeconds(options_.edge_wait);
  last_close_ = std::max(last_close_, std::min(time, interval.close));
  interval.reason = reason;
  const EdgeSource source = reason == EndReason::kContact ? EdgeSource::kContact : EdgeSource::kCommand;
  edges_.push_back({false, interval.close, source, interval.id});
  if (reason == EndReason::kTimeout || reason == EndReason::kStream || reason == EndReason::kTrigger) {
    contact_.EndContact();
  }
}

void EpisodeSegmenter::FinishReady(Nanoseconds now) {
  while (!intervals_.empty() && intervals_.front().closed) {
    const Interval& interval = intervals_.front();
    const bool all_there = !buffer_.empty() && buffer_.back().time >= interval.close;
    // While samples from before the edge arrive, more of them are on their way.
    const Nanoseconds deadline = std::min(interval.deadline + FromSeconds(options_.stream_timeout),
                                          std::max(interval.deadline, last_arrival_ + FromSeconds(options_.edge_wait)));
    if (!all_there && now < deadline) return;
    Emit(interval);
    intervals_.pop_front();
  }
}

void EpisodeSegmenter::Emit(const Interval& interval) {
  const std::vector<WrenchSample> samples = buffer_.Between(interval.open, interval.close);
  if (samples.empty() || interval.close - interval.open < FromSeconds(options_.min_duration)) {
    ++dropped_episodes_;
    return;
  }
  episodes_.push_back(Cut(interval, samples));
}

Eigen::Vector3d EpisodeSegmenter::TareOf(const Interval& interval, const std::vector<WrenchSample>& samples) const {
  if (options_.tare == TareSource::kService) return service_tare_;
  const Nanoseconds duration = FromSeconds(options_.tare_duration);
  if (options_.tare == TareSource::kFreeAir) {
    const std::vector<WrenchSample> before = buffer_.Between(interval.open - duration, interval.open);
    if (!before.empty()) return MeanForce(before, interval.open - duration, interval.open);
  }
  return MeanForce(samples, samples.front().time, samples.front().time + duration);
}

Episode EpisodeSegmenter::Cut(const Interval& interval, const std::vector<WrenchSample>& samples) const {
  Episode episode;
  episode.id = interval.id;
  episode.frame_id = frame_id_;
  episode.start = interval.open;
  episode.sample_period = options_.sample_period;
  episode.force =
      ResampledMagnitude(samples, interval.open, interval.close, options_.sample_period, TareOf(interval, samples));
  episode.complete = interval.reason != EndReason::kStream && !HasGap(interval, samples);
  episode.end_reason = interval.reason;
  return episode;
}

bool EpisodeSegmenter::HasGap(const Interval& interval, const std::vector<WrenchSample>& samples) const {
  const Nanoseconds longest = FromSeconds(options_.max_gap);
  Nanoseconds last = interval.open;
  for (const WrenchSample& sample : samples) {
    if (sample.time - last > longest) return true;
    last = sample.time;
  }
  return interval.close - last > longest;
}

}  // namespace contact_shapelets::core
