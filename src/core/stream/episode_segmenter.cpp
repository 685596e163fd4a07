#include "core/stream/episode_segmenter.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "core/stream/episode_faults.h"
#include "core/stream/resampler.h"

namespace contact_shapelets::core {
namespace {

/// A sequencer that repeats the state of its trigger does so at least as often.
constexpr Nanoseconds kRepeatedState = 2'000'000'000;

constexpr double kGreatestRate = 2000.0;
/// [s] Longest wait of an edge for its place.
constexpr double kPlacing = 2.0;

std::size_t BufferCapacity(const SegmentationOptions& options) {
  const double before = std::max(options.tare_duration, options.pre_trigger + options.contact_hold_on);
  return static_cast<std::size_t>((options.max_duration + before + options.stream_timeout + kPlacing + 1.0) *
                                  kGreatestRate);
}

SegmentationOptions Checked(const SegmentationOptions& options) {
  const std::string faults = options.Faults();
  if (!faults.empty()) throw std::invalid_argument(faults);
  return options;
}

/// Returns an id that is unique within a recording and the same in a replay.
std::string NameByTime(Nanoseconds time) {
  char text[40];
  std::snprintf(text, sizeof(text), "%lld.%03lld", static_cast<long long>(time / 1'000'000'000),
                static_cast<long long>(time / 1'000'000 % 1000));
  return text;
}

}  // namespace

EpisodeSegmenter::EpisodeSegmenter(const SegmentationOptions& options)
    : options_(Checked(options)),
      stream_timeout_(FromSeconds(options_.stream_timeout)),
      max_duration_(FromSeconds(options_.max_duration)),
      contact_(options_),
      buffer_(BufferCapacity(options_)) {}

void EpisodeSegmenter::AddSample(const WrenchSample& sample, Nanoseconds now) {
  // A long pause of the stream ends the episode before the next sample. The samples' times decide, not the arrivals:
  // the backlog of a busy machine arrives late, but whole.
  if (IsOpen() && !buffer_.empty() &&
      sample.time - std::max(buffer_.back().time, intervals_.back().open) > stream_timeout_) {
    EndByStream(now, EpisodeFault::kStreamEnded);
    FinishReady(now);
  }
  buffer_.Add(sample);
  last_arrival_ = now;
  if (options_.segmentation == SegmentationMode::kContact) FollowContact(sample, now);
  if (IsOpen() && sample.time - intervals_.back().open >= max_duration_) {
    intervals_.back().faults |= BitOf(EpisodeFault::kTooLong);
    Close({false, intervals_.back().open + max_duration_, EdgeSource::kCommand, "", now}, EndReason::kTimeout, now);
  }
  FinishReady(now);
}

void EpisodeSegmenter::FollowContact(const WrenchSample& sample, Nanoseconds now) {
  const std::optional<ContactDetector::Change> change = contact_.AddSample(sample, now);
  if (!change) return;
  if (!change->contact) {
    if (change->zero_moved && IsOpen()) intervals_.back().faults |= BitOf(EpisodeFault::kZeroMoved);
    Close({false, change->time, EdgeSource::kContact, "", change->arrival}, EndReason::kContact, now);
  } else if (!IsOpen()) {
    // Two contacts must not share samples, or the first would be in the tare of the second.
    const Nanoseconds time = std::max(change->time, last_close_);
    Open({{true, time, EdgeSource::kContact, "", now}, time, time, false, 0}, now);
  }
}

void EpisodeSegmenter::AddEdge(const PlacedEdge& placed, Nanoseconds now) {
  const EpisodeEdge& edge = placed.edge;
  if (options_.segmentation == SegmentationMode::kContact && edge.source != EdgeSource::kCommand) return;
  if (edge.source == EdgeSource::kUnstamped && IsTwin(edge)) return;
  if (edge.source == EdgeSource::kStamped && TakeStamped(placed, now)) {
    FinishReady(now);
    return;
  }
  if (edge.open && IsOpen()) {
    ++repeated_openings_;
    // A sequencer may repeat its state again and again. An opening out of the blue belongs to another episode.
    if (edge.arrival - last_opening_ > kRepeatedState) intervals_.back().faults |= BitOf(EpisodeFault::kClosingLost);
    last_opening_ = edge.arrival;
  } else if (edge.open) {
    last_opening_ = edge.arrival;
    Open(placed, now);
  } else {
    const bool out_of_the_blue = last_closing_ != 0 && edge.arrival - last_closing_ > kRepeatedState;
    if (!IsOpen() && out_of_the_blue && !closing_is_due_) ++lost_openings_;
    last_closing_ = edge.arrival;
    closing_is_due_ = false;
    Close(edge, EndReason::kTrigger, now, placed.ahead);
  }
  FinishReady(now);
}

void EpisodeSegmenter::AdvanceTo(Nanoseconds now) {
  if (IsOpen() && !buffer_.empty() && now - std::max(last_arrival_, intervals_.back().opened) >= stream_timeout_) {
    EndByStream(now, EpisodeFault::kStreamEnded);
  }
  FinishReady(now);
}

std::optional<Nanoseconds> EpisodeSegmenter::NextDue() const {
  std::optional<Nanoseconds> due;
  if (IsOpen() && !buffer_.empty()) {
    due = std::max(last_arrival_, intervals_.back().opened) + stream_timeout_;
  }
  if (!intervals_.empty() && intervals_.front().closed) {
    const Nanoseconds deadline = DeadlineOf(intervals_.front());
    due = due ? std::min(*due, deadline) : deadline;
  }
  return due;
}

void EpisodeSegmenter::EndByStream(Nanoseconds now, EpisodeFault fault) {
  if (!IsOpen()) return;
  Interval& interval = intervals_.back();
  interval.faults |= BitOf(fault);
  const Nanoseconds last = buffer_.empty() ? interval.open : std::max(buffer_.back().time, interval.open);
  Close({false, last, EdgeSource::kCommand, "", now}, EndReason::kStream, now);
}

void EpisodeSegmenter::Restart(Nanoseconds now) {
  EndByStream(now, EpisodeFault::kClockSet);
  for (Interval& interval : intervals_) {
    if (buffer_.empty() || buffer_.back().time < interval.close) interval.faults |= BitOf(EpisodeFault::kClockSet);
  }
  Finish(now);
  buffer_.Clear();
  contact_ = ContactDetector(options_);
  single_stamps_ = {};
  last_close_ = std::numeric_limits<Nanoseconds>::min();
}

void EpisodeSegmenter::Finish(Nanoseconds now) {
  EndByStream(now, EpisodeFault::kStreamEnded);
  for (Interval& interval : intervals_) Emit(&interval);
  intervals_.clear();
}

Eigen::Vector3d EpisodeSegmenter::MeasureTare() const {
  if (buffer_.empty()) throw std::runtime_error("no wrench has arrived yet: there is nothing to tare");
  const Nanoseconds end = buffer_.back().time;
  const Nanoseconds begin = end - FromSeconds(options_.tare_duration);
  return MeanForce(buffer_.Between(begin, end), begin, end);
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

bool EpisodeSegmenter::IsTwin(const EpisodeEdge& edge) {
  std::optional<Nanoseconds>& stamp = single_stamps_[edge.open ? 1 : 0];
  if (!stamp || std::abs(edge.time - *stamp) > FromSeconds(options_.edge_match_window)) return false;
  stamp.reset();
  return true;
}

bool EpisodeSegmenter::IsStale(const EpisodeEdge& edge) const {
  return edge.open ? edge.time < last_close_ : edge.time <= last_close_;
}

/// Returns true if nothing remains to be done with the edge.
bool EpisodeSegmenter::TakeStamped(const PlacedEdge& placed, Nanoseconds now) {
  const EpisodeEdge& edge = placed.edge;
  if (!edge.open && CorrectClosing(placed, now)) return true;
  if (IsStale(edge)) return true;
  if (!edge.open) {
    single_stamps_[0] = edge.time;
    if (IsOpen()) ProveOpening(placed, &intervals_.back());
    return false;
  }
  if (!IsOpen()) {
    single_stamps_[1] = edge.time;
    return false;
  }
  Interval& interval = intervals_.back();
  const Nanoseconds difference = edge.time - interval.open;
  if (difference <= FromSeconds(options_.edge_match_window)) {
    CorrectOpening(placed);
    return true;
  }
  ++repeated_openings_;
  interval.faults |= BitOf(EpisodeFault::kClosingLost);
  Close({false, edge.time, EdgeSource::kStamped, "", edge.arrival}, EndReason::kUnknown, now);
  single_stamps_[1] = edge.time;
  return false;
}

void EpisodeSegmenter::CorrectOpening(const PlacedEdge& placed) {
  const EpisodeEdge& edge = placed.edge;
  Interval& interval = intervals_.back();
  if (interval.open - edge.time > FromSeconds(options_.edge_match_window)) return;
  if (interval.source != EdgeSource::kStamped) single_stamps_[1].reset();
  interval.source = EdgeSource::kStamped;
  interval.open_by_stamp = placed.by_stamp;
  interval.open_by_arrival = placed.by_arrival;
  if (edge.time == interval.open && (edge.id.empty() || edge.id == interval.id)) return;
  interval.open = edge.time;
  interval.id = edge.id.empty() ? NameByTime(edge.time) : edge.id;
  edges_.push_back({true, edge.time, edge.source, interval.id, edge.arrival});
}

bool EpisodeSegmenter::CorrectClosing(const PlacedEdge& placed, Nanoseconds now) {
  const Nanoseconds time = placed.edge.time;
  for (auto interval = intervals_.rbegin(); interval != intervals_.rend(); ++interval) {
    if (!interval->awaits_stamp || std::abs(time - interval->close) > FromSeconds(options_.edge_match_window)) continue;
    interval->awaits_stamp = false;
    ProveOpening(placed, &*interval);
    if (last_close_ == interval->close) last_close_ = std::max(time, interval->open);
    interval->close = std::clamp(time, interval->open, interval->open + max_duration_);
    interval->deadline = now + placed.ahead + FromSeconds(options_.edge_wait);
    interval->closing.time = interval->close;
    interval->closing.id = interval->id;
    interval->closing.source = placed.edge.source;
    edges_.push_back(interval->closing);
    return true;
  }
  return false;
}

/// A late opening comes from a slow sender or from a clock that is off. The closing tells which: a clock that is off
/// makes both late by the same time.
void EpisodeSegmenter::ProveOpening(const PlacedEdge& closing, Interval* interval) {
  if (interval->source != EdgeSource::kStamped) return;
  const Nanoseconds proven = closing.clock_is_off ? interval->open_by_arrival : interval->open_by_stamp;
  const Nanoseconds open = std::max(proven, interval->earliest);
  if (open == interval->open) return;
  if (interval->id == NameByTime(interval->open)) interval->id = NameByTime(open);
  interval->open = open;
  edges_.push_back({true, open, interval->source, interval->id, interval->opening_arrival});
}

void EpisodeSegmenter::Open(const PlacedEdge& placed, Nanoseconds now) {
  const EpisodeEdge& edge = placed.edge;
  Interval interval;
  interval.id = edge.id.empty() ? NameByTime(edge.time) : edge.id;
  interval.source = edge.source;
  interval.open = edge.time;
  interval.open_by_stamp = placed.by_stamp;
  interval.open_by_arrival = placed.by_arrival;
  interval.opened = now;
  interval.opening_arrival = edge.arrival;
  interval.earliest = last_close_;
  closing_is_due_ = false;
  edges_.push_back({true, edge.time, edge.source, interval.id, edge.arrival});
  intervals_.push_back(std::move(interval));
}

void EpisodeSegmenter::Close(const EpisodeEdge& closing, EndReason reason, Nanoseconds now, Nanoseconds ahead) {
  if (!IsOpen()) return;
  Interval& interval = intervals_.back();
  interval.closed = true;
  interval.close = std::clamp(closing.time, interval.open, interval.open + max_duration_);
  interval.reason = reason;
  interval.awaits_stamp = closing.source == EdgeSource::kUnstamped && interval.source == EdgeSource::kStamped;
  const double wait = interval.awaits_stamp ? options_.edge_match_window : options_.edge_wait;
  interval.deadline = now + ahead + FromSeconds(wait);
  interval.closing = {false, interval.close, closing.source, interval.id, closing.arrival};
  last_close_ = std::max(last_close_, std::min(closing.time, interval.close));
  closing_is_due_ = reason == EndReason::kTimeout || reason == EndReason::kStream;
  if (!interval.awaits_stamp) edges_.push_back(interval.closing);
  if (reason != EndReason::kContact) contact_.EndContact();
}

Nanoseconds EpisodeSegmenter::DeadlineOf(const Interval& interval) const {
  if (interval.awaits_stamp) return interval.deadline;
  // While samples from before the edge arrive, more may be on their way.
  return std::min(interval.deadline + stream_timeout_,
                  std::max(interval.deadline, last_arrival_ + FromSeconds(options_.edge_wait)));
}

void EpisodeSegmenter::FinishReady(Nanoseconds now) {
  while (!intervals_.empty() && intervals_.front().closed) {
    Interval& interval = intervals_.front();
    const bool all_there = !interval.awaits_stamp && !buffer_.empty() && buffer_.back().time >= interval.close;
    if (!all_there && now < DeadlineOf(interval)) return;
    if (interval.awaits_stamp) {
      // No stamped twin came. The samples may still be on their way.
      interval.awaits_stamp = false;
      edges_.push_back(interval.closing);
      continue;
    }
    Emit(&interval);
    intervals_.pop_front();
  }
}

void EpisodeSegmenter::Emit(Interval* interval) {
  if (interval->awaits_stamp) edges_.push_back(interval->closing);
  const std::vector<WrenchSample> samples = buffer_.Between(interval->open, interval->close);
  const bool too_short = interval->close - interval->open < FromSeconds(options_.min_duration);
  if (samples.empty() || too_short) {
    Count(too_short ? EpisodeFault::kTooShort : EpisodeFault::kNoSample);
    return;
  }
  interval->faults |= FaultsOf(samples, interval->open, interval->close, FromSeconds(options_.max_gap));
  for (std::size_t fault = 0; fault < kEpisodeFaults; ++fault) {
    if ((interval->faults >> fault & 1U) != 0) ++fault_counts_[fault];
  }
  if (options_.tare == TareSource::kService && !service_tare_) Count(EpisodeFault::kNotTared);
  episodes_.push_back(Cut(*interval, samples));
}

Eigen::Vector3d EpisodeSegmenter::TareOf(const Interval& interval, const std::vector<WrenchSample>& samples) const {
  if (options_.tare == TareSource::kService) return service_tare_.value_or(Eigen::Vector3d::Zero());
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
  episode.complete = interval.faults == 0;
  episode.end_reason = interval.reason;
  return episode;
}

}  // namespace contact_shapelets::core
