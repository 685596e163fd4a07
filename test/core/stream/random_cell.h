#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "contact_shapelets/core/wrench_stream.h"
#include "core/numerics/random.h"

/// \file
/// A stream as it comes from a real cell, at random, and what happened in truth.

namespace contact_shapelets::core {

/// [s] of a run.
constexpr double kCellDuration = 16.0;
/// [s] What this machine's clock shows at its start.
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

/// Of a message: a wrench or an edge.
enum class Kind { kWrench, kPlain, kStamped };

/// What a node gets.
struct Message {
  Kind kind = Kind::kWrench;
  double sent = 0.0;  ///< true time, as the next
  double arrived = 0.0;
  Nanoseconds stamp = 0;
  Nanoseconds arrival = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  bool open = false;
};

/// The true edges of an episode [s].
struct Truth {
  double open = 0.0;
  double close = 0.0;
};

/// A run: what happens in truth, and the messages in the order of their true arrivals.
class Cell {
 public:
  /// Draws all that happens from `seed`.
  explicit Cell(std::uint64_t seed) : random_(seed) {
    DrawFaults();
    for (double time = random_.Uniform(0.2, 1.5); time < kCellDuration - 2.0;) {
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

  /// What this machine's clock shows at a true time [s].
  Nanoseconds PcClock(double time) const {
    double clock = kPcStart + time;
    if (time >= faults_.pc_step_at) clock += faults_.pc_step;
    if (time >= faults_.jump_at) clock -= faults_.jump;
    return FromSeconds(clock - kPcStart) + FromSeconds(kPcStart);
  }

 private:
  bool Chance(double part) { return random_.Uniform() < part; }
  double At() { return random_.Uniform(3.0, kCellDuration - 4.0); }
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
    for (int index = 0; index < static_cast<int>(kCellDuration * f.rate); ++index) {
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

/// Names the faults of a run, for the message of a test that fails.
inline std::string Describe(int seed, const Cell& cell) {
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

}  // namespace contact_shapelets::core
