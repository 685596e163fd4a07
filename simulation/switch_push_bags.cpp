/// Makes the recorded bags of switch pushes: the same seed gives the same files.

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "contact_shapelets/core/wrench_stream.h"
#include "contact_shapelets/ros/conversions.h"
#include "contact_shapelets/ros/topics.h"
#include "lever_push.h"

namespace contact_shapelets::simulation {
namespace {

constexpr double kRate = 200.0;
constexpr core::Nanoseconds kEpoch = 1'700'000'000'000'000'000;
constexpr char kFrame[] = "flange";

struct Arguments {
  std::uint64_t seed = 1;
  int train = 150;
  int test = 45;
  int raw = 12;
  int samples = 433;
  std::string out = ".";
};

core::Nanoseconds FromSeconds(double seconds) { return static_cast<core::Nanoseconds>(std::llround(seconds * 1e9)); }

/// A push of its own seed, so that it does not depend on those before it.
Eigen::MatrixX3d Push(const Arguments& arguments, std::uint64_t set, int index, Outcome outcome, double duration) {
  core::Random random(arguments.seed * 1'000'000'007ULL + set * 1'000'003ULL + static_cast<std::uint64_t>(index));
  const PushCondition condition = SamplePushCondition(outcome, &random);
  Eigen::MatrixX3d forces = SimulatePush(condition, duration, kRate, &random);
  // The resolution of a controller's estimate; it also lets the bag compress.
  return (forces.array() * 500.0).round() / 500.0;
}

Outcome OutcomeOf(int index) { return static_cast<Outcome>(index % 3); }

/// Writes episodes as the episode node would publish them.
void WriteEpisodes(const Arguments& arguments, std::uint64_t set, int count, const std::string& path) {
  core::SegmentationOptions options;
  const double duration = arguments.samples * options.sample_period;
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::BZ2);
  for (int index = 0; index < count; ++index) {
    const core::Nanoseconds start = kEpoch + FromSeconds(10.0 * index);
    const Eigen::MatrixX3d forces = Push(arguments, set, index, OutcomeOf(index), duration + 0.1);
    core::WrenchStream stream(options);
    stream.segmenter().set_frame_id(kFrame);
    stream.AddStampedEdge(true, start, "", start);
    for (Eigen::Index row = 0; row < forces.rows(); ++row) {
      const core::Nanoseconds time = start + FromSeconds(static_cast<double>(row) / kRate);
      stream.AddWrench(time, time, forces.row(row).transpose());
    }
    stream.AddStampedEdge(false, start + FromSeconds(duration), "", start + FromSeconds(duration + 0.1));
    for (core::Episode& episode : stream.segmenter().TakeEpisodes()) {
      episode.outcome = NameOf(OutcomeOf(index));
      bag.write("/" + std::string(topics::kEpisode), ToTime(start + FromSeconds(duration)), ToMessage(episode));
    }
  }
}

/// Writes what a recorder beside a driver and a sequencer would: wrench, triggers, outcomes.
void WriteRaw(const Arguments& arguments, const std::string& path) {
  constexpr double kCycle = 5.5;
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::BZ2);
  const double duration = arguments.samples * core::SegmentationOptions{}.sample_period;
  for (int index = 0; index < arguments.raw; ++index) {
    const core::Nanoseconds start = kEpoch + FromSeconds(kCycle * index);
    const Eigen::MatrixX3d forces = Push(arguments, 2, index, OutcomeOf(index), kCycle);
    for (Eigen::Index row = 0; row < forces.rows(); ++row) {
      geometry_msgs::WrenchStamped wrench;
      wrench.header.stamp = ToTime(start + FromSeconds(static_cast<double>(row) / kRate));
      wrench.header.frame_id = kFrame;
      wrench.wrench.force.x = forces(row, 0);
      wrench.wrench.force.y = forces(row, 1);
      wrench.wrench.force.z = forces(row, 2);
      bag.write("/" + std::string(topics::kWrench), wrench.header.stamp, wrench);
    }
    const core::Nanoseconds open = start + FromSeconds(0.1);
    const core::Nanoseconds close = open + FromSeconds(duration);
    const auto write_edge = [&bag](core::Nanoseconds time, bool active) {
      std_msgs::Bool message;
      message.data = active ? 1U : 0U;
      bag.write("/" + std::string(topics::kEpisodeActive), ToTime(time), message);
      core::EpisodeEdge edge;
      edge.open = active;
      edge.time = time;
      bag.write("/" + std::string(topics::kEpisodeEvent), ToTime(time + 1'000'000), ToMessage(edge, kFrame));
    };
    write_edge(open, true);
    write_edge(close, false);
    std_msgs::String outcome;
    outcome.data = NameOf(OutcomeOf(index));
    bag.write("/" + std::string(topics::kOutcome), ToTime(close + FromSeconds(0.3)), outcome);
  }
}

}  // namespace
}  // namespace contact_shapelets::simulation

int main(int argc, char** argv) {
  using contact_shapelets::simulation::Arguments;
  Arguments arguments;
  CLI::App app("Makes bags of simulated switch pushes by a simple lever model.");
  app.add_option("--seed", arguments.seed, "Equal seeds give equal files");
  app.add_option("--train", arguments.train, "Episodes of the training bag")->check(CLI::Range(3, 100000));
  app.add_option("--test", arguments.test, "Episodes of the test bag")->check(CLI::Range(3, 100000));
  app.add_option("--raw", arguments.raw, "Pushes of the raw bag")->check(CLI::Range(1, 10000));
  app.add_option("--samples", arguments.samples, "Samples of an episode")->check(CLI::Range(100, 540));
  app.add_option("--out", arguments.out, "The folder to write to")->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  try {
    contact_shapelets::simulation::WriteEpisodes(arguments, 0, arguments.train, arguments.out + "/switch_push_train.bag");
    contact_shapelets::simulation::WriteEpisodes(arguments, 1, arguments.test, arguments.out + "/switch_push_test.bag");
    contact_shapelets::simulation::WriteRaw(arguments, arguments.out + "/switch_push_raw.bag");
  } catch (const std::exception& error) {
    std::cerr << "switch_push_bags: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
