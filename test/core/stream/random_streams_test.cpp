// Streams as they come from real cells, at random: every episode agrees with the truth or is reported as unsound, and
// the calls of a live node give what those of a reader of bags give.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact_shapelets/core/wrench_stream.h"
#include "core/stream/random_cell.h"

namespace contact_shapelets::core {
namespace {

constexpr int kRuns = 10000;

SegmentationOptions Options() {
  SegmentationOptions options;
  options.tare = TareSource::kService;
  options.max_duration = 5.0;
  return options;
}

void Give(const Message& message, WrenchStream* stream) {
  if (message.kind == Kind::kWrench) stream->AddWrench(message.stamp, message.arrival, message.force);
  if (message.kind == Kind::kPlain) stream->AddUnstampedEdge(message.open, message.arrival);
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
  for (int seed = 0; seed < kRuns; ++seed) {
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
  EXPECT_GT(episodes, 6 * kRuns);
  EXPECT_GT(complete, 5 * kRuns);
}

}  // namespace
}  // namespace contact_shapelets::core
