#include "contact_shapelets/core/wrench_stream.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <utility>

#include "core/stream/edge_trust.h"
#include "core/stream/episode_segmenter.h"
#include "core/stream/stream_clock.h"
#include "core/stream/stream_monitor.h"

namespace contact_shapelets::core {
namespace {

/// Messages on different connections may be read in another order than they arrived, by at most this.
constexpr Nanoseconds kReordered = 100'000'000;
/// The relation of the clocks is not known well for this long: the first sample may be the last of a backlog.
constexpr Nanoseconds kSettling = 250'000'000;
/// Within this time a transport that lags and a clock that was set become distinct.
constexpr Nanoseconds kDoubt = 2'000'000'000;
/// Greatest number of edges that wait for the first wrench.
constexpr std::size_t kWaitingEdges = 1000;

/// An edge that has arrived, but has no place among the samples yet.
struct WaitingEdge {
  EpisodeEdge edge;  ///< `time` is the stamp; 0 for an edge without one
  std::string sender;
  Nanoseconds now = 0;        ///< its arrival, on the clock that never goes back
  Nanoseconds last_time = 0;  ///< time of the sample before it; 0 if there is none on the same clock
  Nanoseconds before = 0;     ///< its place by the relation of the clocks when it arrived
  std::int64_t settings = 0;  ///< how often a clock had been set when it arrived
  bool follows_jump = false;  ///< it arrived after time jumped back, but before a sample did
  bool sample_after = false;
};

}  // namespace

struct WrenchStream::Parts {
  explicit Parts(const SegmentationOptions& segmentation) : options(segmentation), segmenter(segmentation) {}

  Nanoseconds TakeArrival(Nanoseconds arrival);
  void AdvanceTo(Nanoseconds to);
  void RunTo(Nanoseconds to);
  void AddEdge(EpisodeEdge edge, const std::string& sender, Nanoseconds arrival);
  std::optional<Nanoseconds> PlaceDue() const;
  bool CanPlace(Nanoseconds at) const;
  void PlaceFront(Nanoseconds at);
  void Restart(bool jumped_back);
  StreamSummary Totals() const;

  SegmentationOptions options;
  StreamClock clock;
  StreamMonitor monitor;
  EpisodeSegmenter segmenter;
  EdgeTrust trust;
  std::deque<WaitingEdge> waiting;
  Nanoseconds now = 0;           ///< advances with arrivals, and never goes back
  Nanoseconds last_arrival = 0;  ///< of any message
  Nanoseconds start = 0;         ///< `now` at the first sample since the stream began or restarted
  Nanoseconds start_time = 0;    ///< time of that sample
  bool status_active = false;
  std::string publisher;
  std::string publisher_before;
  StreamSummary counts;  ///< of edges and publishers
};

/// Advances `now` by the difference of arrivals, or not at all if this machine's clock was set back.
Nanoseconds WrenchStream::Parts::TakeArrival(Nanoseconds arrival) {
  if (last_arrival == 0) now = arrival;
  const Nanoseconds passed = last_arrival == 0 ? 0 : arrival - last_arrival;
  if (passed < 0 && passed >= -kReordered) return now + passed;
  last_arrival = arrival;
  AdvanceTo(now + std::max<Nanoseconds>(0, passed));
  return now;
}

void WrenchStream::Parts::AdvanceTo(Nanoseconds to) {
  // Each wait ends at its own time, even if calls are rare.
  while (true) {
    const std::optional<Nanoseconds> place = PlaceDue();
    std::optional<Nanoseconds> due = segmenter.NextDue();
    if (place && (!due || *place < *due)) due = place;
    if (!due || *due > to) break;
    RunTo(std::max(*due, now));
  }
  now = std::max(now, to);
}

void WrenchStream::Parts::RunTo(Nanoseconds to) {
  now = std::max(now, to);
  while (CanPlace(now)) PlaceFront(now);
  segmenter.AdvanceTo(now);
}

/// Returns when the first waiting edge gets its place, even if nothing arrives before.
std::optional<Nanoseconds> WrenchStream::Parts::PlaceDue() const {
  if (waiting.empty() || !clock.has_started() || waiting.front().follows_jump) return std::nullopt;
  const Nanoseconds wait = clock.is_in_doubt() ? kDoubt : FromSeconds(options.edge_wait);
  return std::max(waiting.front().now + wait, start + kSettling);
}

bool WrenchStream::Parts::CanPlace(Nanoseconds at) const {
  const std::optional<Nanoseconds> due = PlaceDue();
  if (!due) return false;
  const WaitingEdge& front = waiting.front();
  // The place of a stamped edge hardly depends on the relation of the clocks. So samples of a backlog are enough.
  const bool settled = at >= start + kSettling ||
                       (front.edge.source == EdgeSource::kStamped && clock.last_time() - start_time >= kSettling);
  return at >= *due || (front.sample_after && !clock.is_in_doubt() && settled);
}

/// If a clock was set between the arrival of the edge and now, the relations before and after give two places. The one
/// nearer to the sample before the edge is right.
void WrenchStream::Parts::PlaceFront(Nanoseconds at) {
  const WaitingEdge edge = std::move(waiting.front());
  waiting.pop_front();
  Nanoseconds time = clock.FromArrival(edge.edge.arrival);
  if (edge.settings != clock.arrival_steps() && edge.last_time != 0 &&
      std::abs(edge.before - edge.last_time) < std::abs(time - edge.last_time)) {
    time = edge.before;
  }
  const Nanoseconds earliest = time;
  // Edges take as long as wrenches. With their mean delay, the greatest error is half the jitter.
  time -= clock.usual_delay();
  PlacedEdge placed{edge.edge, time, time, false, 0};
  if (edge.edge.source == EdgeSource::kStamped) {
    const Nanoseconds stamp = edge.edge.time;
    const Nanoseconds lateness = earliest - stamp;
    const Nanoseconds longest = FromSeconds(options.max_duration + options.stream_timeout);
    // No edge arrives long before it happens.
    const bool ahead = lateness < -FromSeconds(options.edge_match_window);
    placed.clock_is_off = trust.IsClockOff(edge.sender, lateness, longest) || ahead;
    placed.by_stamp = std::abs(lateness) > longest ? time : stamp;
    if (placed.clock_is_off) {
      ++counts.distrusted_edges;
      counts.edge_lateness = ToSeconds(lateness);
    } else if (lateness <= FromSeconds(options.stream_timeout)) {
      time = stamp;
    }
  }
  placed.edge.time = time;
  placed.edge.arrival = edge.now;
  placed.ahead = std::max<Nanoseconds>(0, time - earliest);
  segmenter.AddEdge(placed, at);
}

/// Edges from before the restart belong to the old stream. So do closings of an episode that was open then.
void WrenchStream::Parts::Restart(bool jumped_back) {
  while (!waiting.empty() && !waiting.front().follows_jump) {
    const EpisodeEdge& edge = waiting.front().edge;
    if (!jumped_back && edge.open && edge.arrival >= clock.start_arrival()) break;
    PlaceFront(now);
  }
  for (WaitingEdge& edge : waiting) edge.last_time = 0;
  monitor.Restart();
  segmenter.Restart(now);
}

void WrenchStream::Parts::AddEdge(EpisodeEdge edge, const std::string& sender, Nanoseconds arrival) {
  if (waiting.size() >= kWaitingEdges) waiting.pop_front();
  edge.arrival = arrival;
  WaitingEdge entry{std::move(edge), sender};
  entry.follows_jump = clock.has_started() && arrival < clock.last_arrival() - kReordered;
  entry.now = TakeArrival(arrival);
  entry.last_time = clock.last_time();
  entry.before = clock.FromArrival(arrival);
  entry.settings = clock.arrival_steps();
  entry.sample_after = !entry.follows_jump && clock.has_started() && clock.last_arrival() >= arrival;
  waiting.push_back(std::move(entry));
  RunTo(now);
}

StreamSummary WrenchStream::Parts::Totals() const {
  StreamSummary totals = counts;
  totals.zero_stamps = clock.zero_stamps();
  totals.wrong_stamps = clock.wrong_stamps();
  totals.jumps_back = clock.jumps_back();
  totals.stamp_steps = clock.stamp_steps();
  totals.arrival_steps = clock.arrival_steps();
  totals.clock_offset = ToSeconds(clock.offset());
  totals.clock_drift = clock.drift();
  totals.clock_rate = clock.rate();
  totals.episode_faults = segmenter.fault_counts();
  totals.repeated_openings = segmenter.repeated_openings();
  totals.lost_openings = segmenter.lost_openings();
  totals.without_baseline = segmenter.without_baseline();
  const bool can_wait = waiting.empty() || (clock.has_started() && !waiting.front().follows_jump);
  totals.waiting_edges = can_wait ? 0 : static_cast<std::int64_t>(waiting.size());
  return totals;
}

WrenchStream::WrenchStream(const SegmentationOptions& options) : parts_(std::make_unique<Parts>(options)) {}
WrenchStream::~WrenchStream() = default;
WrenchStream::WrenchStream(WrenchStream&&) noexcept = default;
WrenchStream& WrenchStream::operator=(WrenchStream&&) noexcept = default;

bool WrenchStream::AddWrench(Nanoseconds stamp, Nanoseconds arrival, const Eigen::Vector3d& force) {
  Parts& parts = *parts_;
  parts.TakeArrival(arrival);
  if (!(force.norm() <= kGreatestForce)) {
    parts.monitor.AddNotFinite();
    return false;
  }
  // A driver may repeat its last message while its sensor measures nothing new.
  if (parts.clock.IsLastStamp(stamp) && parts.monitor.IsLastForce(force)) {
    parts.monitor.AddRepeatedMessage(parts.clock.FromArrival(arrival));
    return false;
  }
  const bool first = !parts.clock.has_started();
  const std::int64_t jumps_back = parts.clock.jumps_back();
  const SampleTime sample = parts.clock.Resolve(stamp, arrival);
  if (sample.verdict == SampleTime::Verdict::kOutOfOrder) {
    parts.monitor.AddOutOfOrder();
    return false;
  }
  if (sample.verdict == SampleTime::Verdict::kRestarted) {
    parts.Restart(jumps_back != parts.clock.jumps_back());
  }
  if (first || sample.verdict == SampleTime::Verdict::kRestarted) {
    parts.start = parts.now;
    parts.start_time = sample.time;
  }
  for (WaitingEdge& edge : parts.waiting) {
    edge.sample_after = true;
    edge.follows_jump = false;
  }
  parts.monitor.AddSample(sample.time, force);
  parts.segmenter.AddSample({sample.time, force, stamp != 0 && !sample.by_stamp}, parts.now);
  if (!parts.waiting.empty()) parts.RunTo(parts.now);
  return true;
}

void WrenchStream::AddUnstampedEdge(bool open, Nanoseconds arrival, const std::string& id) {
  parts_->AddEdge({open, 0, EdgeSource::kUnstamped, id}, "", arrival);
}

void WrenchStream::AddCommand(bool open, Nanoseconds arrival) {
  parts_->AddEdge({open, 0, EdgeSource::kCommand, ""}, "", arrival);
}

void WrenchStream::AddStampedEdge(bool open, Nanoseconds stamp, const std::string& id, Nanoseconds arrival,
                                  const std::string& sender) {
  // An event without a stamp counts as unstamped.
  const EdgeSource source = stamp == 0 ? EdgeSource::kUnstamped : EdgeSource::kStamped;
  parts_->AddEdge({open, stamp, source, id}, sender, arrival);
}

void WrenchStream::AddStatus(bool active, Nanoseconds arrival) {
  if (active == std::exchange(parts_->status_active, active)) return;
  AddUnstampedEdge(active, arrival);
}

void WrenchStream::AdvanceTo(Nanoseconds arrival) { parts_->TakeArrival(arrival); }

void WrenchStream::Finish() {
  Parts& parts = *parts_;
  while (!parts.waiting.empty() && parts.clock.has_started()) parts.PlaceFront(parts.now);
  parts.segmenter.Finish(parts.now);
}

Eigen::Vector3d WrenchStream::TareNow() {
  const Eigen::Vector3d tare = parts_->segmenter.MeasureTare();
  parts_->segmenter.set_tare(tare);
  return tare;
}

Nanoseconds WrenchStream::last_wrench() const { return parts_->clock.last_time(); }

void WrenchStream::SetTare(const Eigen::Vector3d& tare) { parts_->segmenter.set_tare(tare); }

void WrenchStream::SetPublisher(const std::string& name) {
  if (name == parts_->publisher) return;
  if (name == parts_->publisher_before) ++parts_->counts.publisher_turns;
  parts_->publisher_before = std::exchange(parts_->publisher, name);
}

void WrenchStream::set_frame_id(const std::string& frame_id) { parts_->segmenter.set_frame_id(frame_id); }

bool WrenchStream::IsOpen() const {
  return parts_->waiting.empty() ? parts_->segmenter.IsOpen() : parts_->waiting.back().edge.open;
}

std::optional<Episode> WrenchStream::OpenEpisode() const { return parts_->segmenter.OpenEpisode(); }

bool WrenchStream::HasNews() const { return parts_->segmenter.HasNews(); }

std::vector<Episode> WrenchStream::TakeEpisodes() { return parts_->segmenter.TakeEpisodes(); }

std::vector<EpisodeEdge> WrenchStream::TakeEdges() { return parts_->segmenter.TakeEdges(); }

StreamSummary WrenchStream::Summary() const {
  StreamMonitor monitor = parts_->monitor;
  monitor.SetTotals(parts_->Totals());
  return monitor.Summary();
}

StreamSummary WrenchStream::TakeLap() {
  parts_->monitor.SetTotals(parts_->Totals());
  return parts_->monitor.TakeLap();
}

}  // namespace contact_shapelets::core
