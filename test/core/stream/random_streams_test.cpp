// Streams as they come from real cells, at random: every episode agrees with the truth or is reported as unsound, and
// the calls of a live node give what those of a reader of bags give.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "contact_shapelets/core/wrench_stream.h"
#include "core/numerics/random.h"
#include "core/stream/wrench_signal.h"

namespace contact_shapelets::core {
namespace {

constexpr int kRuns = 10000;
constexpr double kDuration = 16.0;
constexpr double kPcStart = 1.7e9;
/// [N/s] The force tells the true time.
constexpr double kSlope = 5.0;

/// What is wrong in a run; times are in true seconds.
struct Faults {
  double rate = 100.0;
  double latency = 0.001;
  double jitter = 0.0;
  double stall_at = -1.0, stall = 0.0;
  double offset = 0.0, drift = 0.0;
  double pc_step_at = 99.0, pc_step = 0.0;
  double driver_step_at = 99.0, driver_step = 0.0;
  double jump_at = 99.0, jump = 0.0;
  double silent_at = 99.0, silent = 0.0;
  double node_restart_at = 99.0;
  double wrong_stamps = 0.0, zero_stamps = 0.0, repeated = 0.0, lost = 0.0;
  double early_events = 0.0;
  int lost_edge = -1;
  int edges = 0;  ///< 0 plain, 1 stamped, 2 both, 3 plain and then stamped, 4 plain and a stray stamped one
};

enum class Kind { kWrench, kPlain, kStamped };

struct Message {
  Kind kind = Kind::kWrench;
  double sent = 0.0;  ///< true time, as the next
  double arrived = 0.0;
  Nanoseconds stamp = 0;
  Nanoseconds arrival = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  bool open = false;
};

struct Truth {
  double open = 0.0;
  double close = 0.0;
};

/// A run: what happens in truth, and the messages in the order of their true arrivals.
class Cell {
 public:
  explicit Cell(std::uint64_t seed) : random_(seed) {
    DrawFaults();
    for (double time = random_.Uniform(0.2, 1.5); time < kDuration - 2.0;) {
      truth_.push_back({time, time + random_.Uniform(0.4, 1.2)});
      time = truth_.back().close + random_.Uniform(0.6, 1.5);
    }
    MakeWrenches();
    MakeEdges();
    std::stable_sort(messages_.begin(), messages_.end(),
                     [](const Message& one, const Message& other) { return one.arrived < other.arrived; });
    for (Message& message : messages_) message.arrival = PcClock(message.arrived);
  }

  const Faults& faults() const { return faults_; }
  const std::vector<Truth>& truth() const { return truth_; }
  const std::vector<Message>& messages() const { return messages_; }
  Random* random() { return &random_; }

  Nanoseconds PcClock(double time) const {
    double clock = kPcStart + time;
    if (time >= faults_.pc_step_at) clock += faults_.pc_step;
    if (time >= faults_.jump_at) clock -= faults_.jump;
    return FromSeconds(clock - kPcStart) + FromSeconds(kPcStart);
  }

 private:
  bool Chance(double part) { return random_.Uniform() < part; }
  double At() { return random_.Uniform(3.0, kDuration - 4.0); }
  double Signed(double low, double high) { return (Chance(0.5) ? 1.0 : -1.0) * random_.Uniform(low, high); }

  void DrawFaults() {
    Faults& f = faults_;
    const double rates[] = {30.0, 100.0, 200.0};
    f.rate = rates[random_.Index(3)];
    f.latency = random_.Uniform(0.0, 0.005);
    if (Chance(0.5)) f.jitter = random_.Uniform(0.0, 0.02);
    if (Chance(0.3)) f.offset = Chance(0.5) ? Signed(0.01, 0.6) : Signed(1.0, 1e9);
    if (Chance(0.3)) f.drift = Signed(1e-6, 5e-4);
    f.edges = random_.Index(5);
    const int fault = random_.Index(14);
    if (fault == 1) {
      f.pc_step_at = At();
      f.pc_step = Signed(0.05, 3.0);
    }
    if (fault == 2) {
      f.driver_step_at = At();
      f.driver_step = Signed(0.15, 30.0);
    }
    if (fault == 3) {
      f.jump_at = At();
      f.jump = random_.Uniform(1.0, 1000.0);
    }
    if (fault == 4) {
      f.silent_at = At();
      f.silent = random_.Uniform(0.05, 3.0);
      f.driver_step_at = f.silent_at;
      f.driver_step = Chance(0.5) ? Signed(0.0, 1e6) : 0.0;
    }
    if (fault == 5) f.node_restart_at = 0.004 * std::floor(At() / 0.004);
    if (fault == 6) f.wrong_stamps = random_.Uniform(0.001, 0.02);
    if (fault == 7) {
      f.zero_stamps = Chance(0.5) ? 1.0 : random_.Uniform(0.0, 0.5);
      f.offset = f.drift = 0.0;
    }
    if (fault == 8) f.repeated = random_.Uniform(0.0, 0.2);
    if (fault == 9) f.lost = random_.Uniform(0.0, 0.02);
    if (fault == 10) {
      f.early_events = Signed(0.2, 1.0);
      f.edges = 1;
    }
    if (fault == 11) {
      f.lost_edge = random_.Index(8);
      f.edges = random_.Index(4);
    }
    if (fault == 12) {
      f.stall_at = At();
      f.stall = random_.Uniform(0.05, 0.8);
    }
  }

  Nanoseconds DriverClock(double time) const {
    double clock = kPcStart + faults_.offset + time * (1.0 + faults_.drift);
    if (time >= faults_.driver_step_at) clock += faults_.driver_step;
    if (time >= faults_.jump_at) clock -= faults_.jump;
    return FromSeconds(clock - kPcStart) + FromSeconds(kPcStart);
  }

  void MakeWrenches() {
    double last_arrival = 0.0;
    const Faults& f = faults_;
    for (int index = 0; index < static_cast<int>(kDuration * f.rate); ++index) {
      Message message;
      message.sent = index / f.rate;
      if (message.sent >= f.silent_at && message.sent < f.silent_at + f.silent) continue;
      message.force = {1e-6 * index, 0.0, kSlope * message.sent};
      message.stamp = DriverClock(message.sent);
      if (Chance(f.wrong_stamps)) message.stamp += FromSeconds(Chance(0.5) ? Signed(0.03, 2.0) : Signed(10.0, 1e8));
      if (Chance(f.zero_stamps)) message.stamp = 0;
      message.arrived = message.sent + f.latency + random_.Uniform(0.0, f.jitter);
      if (message.arrived >= f.stall_at) message.arrived = std::max(message.arrived, f.stall_at + f.stall);
      // One connection keeps its order.
      message.arrived = last_arrival = std::max(message.arrived, last_arrival + 1e-5);
      if (Chance(f.lost)) continue;
      messages_.push_back(message);
      if (message.stamp != 0 && Chance(f.repeated)) {
        message.arrived = last_arrival = last_arrival + 0.001;
        messages_.push_back(message);
      }
    }
  }

  void AddEdge(Kind kind, bool open, double time) {
    Message message;
    message.kind = kind;
    message.open = open;
    message.sent = time;
    message.arrived = time + faults_.latency + random_.Uniform(0.0, faults_.jitter);
    if (kind == Kind::kStamped) message.stamp = DriverClock(time) - FromSeconds(faults_.early_events);
    messages_.push_back(message);
  }

  void MakeEdges() {
    int edge = 0;
    for (std::size_t index = 0; index < truth_.size(); ++index) {
      const bool first_half = 2 * index < truth_.size();
      for (const bool open : {true, false}) {
        const double time = open ? truth_[index].open : truth_[index].close;
        const bool lost = edge++ == faults_.lost_edge;
        const int kind = faults_.edges;
        if (kind != 1 && !(kind == 3 && !first_half) && !lost) AddEdge(Kind::kPlain, open, time);
        if ((kind == 1 || kind == 2 || (kind == 3 && !first_half)) && !lost) AddEdge(Kind::kStamped, open, time);
      }
      if (faults_.edges == 4 && index == 1) AddEdge(Kind::kStamped, false, truth_[index].close + 0.3);
    }
  }

  Random random_;
  Faults faults_;
  std::vector<Truth> truth_;
  std::vector<Message> messages_;
};

SegmentationOptions Options() {
  SegmentationOptions options;
  options.tare = TareSource::kService;
  options.max_duration = 5.0;
  return options;
}

void Give(const Message& message, WrenchStream* stream) {
  if (message.kind == Kind::kWrench) stream->AddWrench(message.stamp, message.arrival, message.force);
  if (message.kind == Kind::kPlain) stream->AddPlainEdge(message.open, message.arrival);
  if (message.kind == Kind::kStamped) {
    stream->AddStampedEdge(message.open, message.stamp, "", message.arrival, "sequencer");
  }
}

struct Result {
  std::vector<Episode> episodes;
  StreamSummary summary;
};

void Take(WrenchStream* stream, Result* result) {
  for (Episode& episode : stream->TakeEpisodes()) result->episodes.push_back(std::move(episode));
  stream->TakeEdges();
}

/// As the reader of bags does: messages one by one, by the arrivals that were recorded.
Result Offline(Cell* cell, bool by_arrival) {
  std::vector<Message> messages = cell->messages();
  if (by_arrival) {
    std::stable_sort(messages.begin(), messages.end(),
                     [](const Message& one, const Message& other) { return one.arrival < other.arrival; });
  }
  Result result;
  WrenchStream stream(Options());
  bool restarted = false;
  for (const Message& message : messages) {
    if (message.arrived >= cell->faults().node_restart_at && !restarted) {
      restarted = true;
      stream = WrenchStream(Options());
    }
    stream.AdvanceTo(message.arrival);
    Give(message, &stream);
    if (stream.HasNews()) Take(&stream, &result);
  }
  stream.Finish();
  Take(&stream, &result);
  result.summary = stream.Summary();
  return result;
}

/// As the node does: wrenches in batches of some milliseconds and before each edge, and time that passes in pauses.
Result Live(Cell* cell) {
  Result result;
  WrenchStream stream(Options());
  const std::vector<Message>& messages = cell->messages();
  bool restarted = false;
  std::size_t next = 0;
  double idle_since = 0.0;
  for (double now = 0.0; next < messages.size(); now += 0.004) {
    const std::size_t begin = next;
    while (next < messages.size() && messages[next].arrived <= now) ++next;
    for (const bool edges : {false, true}) {
      for (std::size_t index = begin; index < next; ++index) {
        if ((messages[index].kind != Kind::kWrench) == edges) Give(messages[index], &stream);
      }
    }
    if (stream.HasNews()) Take(&stream, &result);
    if (now + 1e-9 >= cell->faults().node_restart_at && !restarted) {
      restarted = true;
      stream = WrenchStream(Options());
    }
    if (next > begin) idle_since = now;
    if (now - idle_since > 0.032) stream.AdvanceTo(cell->PcClock(now));
    if (stream.HasNews()) Take(&stream, &result);
  }
  stream.Finish();
  Take(&stream, &result);
  result.summary = stream.Summary();
  return result;
}

/// When the episode began in truth, by its forces; robust against a few samples at a wrong place.
Truth TruthOf(const Episode& episode) {
  std::vector<double> begins;
  for (Eigen::Index index = 0; index < episode.force.size(); ++index) {
    begins.push_back(static_cast<double>(episode.force[index]) / kSlope - 0.01 * (static_cast<double>(index) + 0.5));
  }
  std::nth_element(begins.begin(), begins.begin() + static_cast<std::ptrdiff_t>(begins.size() / 2), begins.end());
  const double begin = begins[begins.size() / 2];
  return {begin, begin + episode.duration()};
}

/// The greatest error of both edges that is promised [s]; an episode is cut to whole sample periods.
double Tolerance(const Faults& faults) {
  const double exact = 0.5 / faults.rate;
  const bool stamps = faults.edges == 1 && faults.early_events == 0.0;
  // Without stamps, forces carry the transport's delay themselves.
  if (faults.zero_stamps > 0.0) return 0.005 + faults.latency + faults.jitter + exact;
  return stamps ? exact + 1e-3 : 0.005 + 0.5 * faults.jitter + exact;
}

bool Agrees(const Episode& episode, const Cell& cell, double tolerance) {
  const Truth seen = TruthOf(episode);
  return std::any_of(cell.truth().begin(), cell.truth().end(), [&](const Truth& truth) {
    return std::abs(seen.open - truth.open) <= tolerance && seen.close - truth.close <= tolerance &&
           seen.close - truth.close >= -tolerance - 0.01;
  });
}

bool IsReported(const Episode& episode, const Cell& cell, const StreamSummary& summary) {
  if (!episode.complete || episode.end_reason == EndReason::kTimeout) return true;
  return cell.faults().lost_edge >= 0 && summary.repeated_openings > 0;
}

/// Whether nothing happens from shortly before the episode until its clocks are known again.
bool IsUntouched(const Truth& truth, const Cell& cell, int index) {
  const Faults& f = cell.faults();
  for (const double at : {f.pc_step_at, f.driver_step_at, f.jump_at, f.silent_at, f.node_restart_at, f.stall_at}) {
    if (at > truth.open - 4.0 && at < truth.close + 1.0) return false;
  }
  const bool spoiled = f.wrong_stamps > 0.0 || f.lost > 0.0 || f.repeated > 0.0 || f.zero_stamps > 0.0;
  return !spoiled && (f.lost_edge < 0 || index > f.lost_edge / 2 + 1 || index < f.lost_edge / 2 - 1) &&
         truth.open > 1.0;
}

std::string Describe(int seed, const Cell& cell) {
  const Faults& f = cell.faults();
  char text[600];
  std::snprintf(
      text, sizeof(text),
      "seed %d: rate %g latency %g jitter %g edges %d offset %g drift %g pc %g@%g driver %g@%g jump %g@%g silent "
      "%g@%g node %g wrong %g zero %g repeated %g lost %g early %g edge %d stall %g@%g",
      seed, f.rate, f.latency, f.jitter, f.edges, f.offset, f.drift, f.pc_step, f.pc_step_at, f.driver_step,
      f.driver_step_at, f.jump, f.jump_at, f.silent, f.silent_at, f.node_restart_at, f.wrong_stamps, f.zero_stamps,
      f.repeated, f.lost, f.early_events, f.lost_edge, f.stall, f.stall_at);
  return text;
}

void ExpectTruth(const Result& result, const Cell& cell, int seed, const char* way) {
  const double tolerance = Tolerance(cell.faults());
  for (const Episode& episode : result.episodes) {
    if (Agrees(episode, cell, tolerance) || IsReported(episode, cell, result.summary)) continue;
    const Truth seen = TruthOf(episode);
    const Truth nearest = *std::min_element(
        cell.truth().begin(), cell.truth().end(),
        [&](const auto& a, const auto& b) { return std::abs(a.open - seen.open) < std::abs(b.open - seen.open); });
    ADD_FAILURE() << "in truth " << nearest.open << " to " << nearest.close << ", but " << way << ' ' << seen.open
                  << " to " << seen.close << ", tolerance " << tolerance << "; " << Describe(seed, cell);
  }
}

void ExpectUntouched(const Result& result, const Cell& cell, int seed) {
  int index = 0;
  for (const Truth& truth : cell.truth()) {
    if (!IsUntouched(truth, cell, index++)) continue;
    const bool found = std::any_of(result.episodes.begin(), result.episodes.end(), [&](const Episode& episode) {
      return episode.complete && std::abs(TruthOf(episode).open - truth.open) < 0.05;
    });
    EXPECT_TRUE(found) << "missing " << truth.open << " to " << truth.close << "; " << Describe(seed, cell);
  }
}

void ExpectEqual(const Result& live, const Result& offline, const Cell& cell, int seed) {
  ASSERT_EQ(live.episodes.size(), offline.episodes.size()) << Describe(seed, cell);
  for (std::size_t index = 0; index < live.episodes.size(); ++index) {
    const Episode& one = live.episodes[index];
    const Episode& other = offline.episodes[index];
    const double difference = std::abs(ToSeconds(one.start - other.start));
    EXPECT_EQ(one.complete, other.complete) << index << ' ' << Describe(seed, cell);
    EXPECT_LE(difference, cell.faults().edges == 1 && cell.faults().early_events == 0.0 ? 0.0 : 0.002)
        << index << ' ' << Describe(seed, cell);
    EXPECT_LE(std::abs(one.force.size() - other.force.size()), 1) << index << ' ' << Describe(seed, cell);
  }
}

TEST(RandomStreams, EveryEpisodeAgreesWithTheTruthOrIsReportedAndLiveIsOffline) {
  int episodes = 0;
  int complete = 0;
  const char* const only = std::getenv("SEED");
  for (int seed = 0; seed < kRuns; ++seed) {
    if (only != nullptr && seed != std::atoi(only)) continue;
    Cell cell(static_cast<std::uint64_t>(seed));
    const Result live = Live(&cell);
    const Result offline = Offline(&cell, false);
    ExpectTruth(live, cell, seed, "live");
    ExpectUntouched(live, cell, seed);
    ExpectEqual(live, offline, cell, seed);
    // A recording across a clock that was set back is in the order of that clock.
    if (cell.faults().pc_step < 0.0) {
      const Result recorded = Offline(&cell, true);
      if (recorded.summary.stamp_steps == 0) ExpectTruth(recorded, cell, seed, "recorded");
      EXPECT_GT(recorded.summary.stamp_steps + recorded.summary.arrival_steps + recorded.summary.jumps_back, 0)
          << Describe(seed, cell);
    }
    episodes += static_cast<int>(live.episodes.size());
    for (const Episode& episode : live.episodes) complete += episode.complete ? 1 : 0;
  }
  if (only == nullptr) {
    EXPECT_GT(episodes, 6 * kRuns);
    EXPECT_GT(complete, 5 * kRuns);
  }
}

}  // namespace
}  // namespace contact_shapelets::core
