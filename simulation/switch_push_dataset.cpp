/// Makes bags of simulated switch pushes. Equal seeds give equal files.

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <boost/program_options.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "contact_shapelets/core/wrench_stream.h"
#include "core/numerics/parallel.h"
#include "push_recording.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "wrench_message.h"

namespace contact_shapelets::simulation {
namespace {

constexpr core::Nanoseconds kEpoch = 1'700'000'000'000'000'000;
constexpr double kEdgeMargin = 0.1;  // [s] of wrench after an episode's end

/// Each set of pushes has its own random numbers.
enum class Set : std::uint64_t { kTrain, kTest, kRaw, kNovel };

struct Arguments {
  std::uint64_t seed = 1;
  int train = 489;
  int test = 81;
  int raw = 12;
  int novel = 0;
  int samples = 433;
  int threads = 0;
  double raw_rate = 200.0;
  std::string out = ".";

  double Duration() const { return samples * core::SegmentationOptions{}.sample_period; }

  /// \throws std::invalid_argument that names the first argument out of range.
  void Check() const {
    for (const int count : {train, test, raw, novel, threads}) {
      if (count < 0 || count > 100000)
        throw std::invalid_argument("a number of episodes or threads is not in 0 to 100000");
    }
    if (samples < 400 || samples > 10000) throw std::invalid_argument("--samples must be from 400 to 10000");
    if (!(raw_rate >= 30.0 && raw_rate <= 1000.0)) throw std::invalid_argument("--raw-rate must be from 30 to 1000");
    if (!std::filesystem::is_directory(out)) throw std::invalid_argument("--out: there is no folder " + out);
  }
};

/// Returns the random numbers of one push, so that a push does not depend on those before it.
core::Random RandomOf(const Arguments& arguments, Set set, int index) {
  return core::Random(arguments.seed * 1'000'000'007ULL + static_cast<std::uint64_t>(set) * 1'000'003ULL +
                      static_cast<std::uint64_t>(index));
}

Outcome OutcomeOf(Set set, int index) {
  const auto third = static_cast<std::size_t>(index % 3);
  return AllOutcomes()[set == Set::kNovel ? third + 3 : third];
}

/// Returns the episode that the episode node would make of a push.
core::Episode MakeEpisode(const Arguments& arguments, Set set, int index) {
  core::Random random = RandomOf(arguments, set, index);
  const PushRecording recording = RecordOutcome(OutcomeOf(set, index), arguments.Duration() + kEdgeMargin, &random);
  const core::Nanoseconds start = kEpoch + core::FromSeconds(10.0 * index);
  core::WrenchStream stream(core::SegmentationOptions{});
  stream.set_frame_id(kWrenchFrame);
  stream.AddStampedEdge(true, start, "", start);
  for (const CellState& state : recording.states) {
    const core::Nanoseconds time = start + core::FromSeconds(state.time);
    stream.AddWrench(time, time, ToVector(WrenchMessage(state, ToTime(time)).wrench.force));
  }
  stream.AddStampedEdge(false, start + core::FromSeconds(arguments.Duration()), "",
                        start + core::FromSeconds(arguments.Duration() + kEdgeMargin));
  std::vector<core::Episode> episodes = stream.TakeEpisodes();
  if (episodes.size() != 1) throw std::logic_error("a push gave " + std::to_string(episodes.size()) + " episodes");
  episodes.front().outcome = NameOf(recording.outcome);
  return episodes.front();
}

void WriteEpisodes(const Arguments& arguments, Set set, int count, const std::string& path) {
  std::vector<core::Episode> episodes(static_cast<std::size_t>(count));
  core::ParallelFor(count, core::ThreadCount(arguments.threads),
                    [&](int index) { episodes[static_cast<std::size_t>(index)] = MakeEpisode(arguments, set, index); });
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::BZ2);
  for (int index = 0; index < count; ++index) {
    const core::Nanoseconds end = kEpoch + core::FromSeconds(10.0 * index + arguments.Duration());
    bag.write("/" + std::string(topics::kEpisode), ToTime(end), ToMessage(episodes[static_cast<std::size_t>(index)]));
  }
  std::cerr << path << ": " << count << " episodes\n";
}

/// Writes the bag that a recorder would: wrench, triggers, outcomes.
class RawWriter {
 public:
  RawWriter(const Arguments& arguments, const std::string& path)
      : arguments_(arguments), bag_(path, rosbag::bagmode::Write) {
    bag_.setCompression(rosbag::compression::BZ2);
  }

  void Write() {
    constexpr double kBefore = 1.2;  // [s] in which the arm goes to its start
    constexpr double kAfter = 1.0;   // [s] after the episode
    SimulatedCell cell(ConditionOf(0));
    for (int index = 0; index < arguments_.raw; ++index) {
      if (index > 0) cell.SetUp(ConditionOf(index));
      Run(&cell, kBefore);
      WriteEdge(true);
      cell.BeginPush();
      Run(&cell, arguments_.Duration());
      WriteEdge(false);
      Run(&cell, 0.3);
      std_msgs::String outcome;
      outcome.data = NameOf(cell.ObservedOutcome().value());
      bag_.write("/" + std::string(topics::kOutcome), ToTime(now_), outcome);
      Run(&cell, kAfter - 0.3);
    }
  }

 private:
  PushCondition ConditionOf(int index) const {
    core::Random random = RandomOf(arguments_, Set::kRaw, index);
    return RecordOutcome(OutcomeOf(Set::kRaw, index), arguments_.Duration(), &random).condition;
  }

  void Run(SimulatedCell* cell, double duration) {
    const auto cycles = std::lround(duration / SimulatedCell::kPeriod);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
      now_ += core::FromSeconds(SimulatedCell::kPeriod);
      const CellState& state = cell->Step();
      if (core::ToSeconds(now_ - kEpoch) * arguments_.raw_rate < static_cast<double>(written_)) continue;
      bag_.write("/" + std::string(topics::kWrench), ToTime(now_), WrenchMessage(state, ToTime(now_)));
      ++written_;
    }
  }

  void WriteEdge(bool active) {
    std_msgs::Bool message;
    message.data = active ? 1U : 0U;
    bag_.write("/" + std::string(topics::kEpisodeActive), ToTime(now_), message);
    core::EpisodeEdge edge;
    edge.open = active;
    edge.time = now_;
    bag_.write("/" + std::string(topics::kEpisodeEvent), ToTime(now_ + 1'000'000), ToMessage(edge, kWrenchFrame));
  }

  Arguments arguments_;
  rosbag::Bag bag_;
  core::Nanoseconds now_ = kEpoch;
  std::int64_t written_ = 0;
};

void WriteAll(const Arguments& arguments) {
  const std::string path = arguments.out + "/switch_push_";
  if (arguments.train > 0) WriteEpisodes(arguments, Set::kTrain, arguments.train, path + "train.bag");
  if (arguments.test > 0) WriteEpisodes(arguments, Set::kTest, arguments.test, path + "test.bag");
  if (arguments.novel > 0) WriteEpisodes(arguments, Set::kNovel, arguments.novel, path + "novel.bag");
  if (arguments.raw > 0) RawWriter(arguments, path + "raw.bag").Write();
}

}  // namespace
}  // namespace contact_shapelets::simulation

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  contact_shapelets::simulation::Arguments arguments;
  const auto value = [](auto* target) { return po::value(target)->default_value(*target); };
  po::options_description options("Makes bags of switch pushes in the simulated cell");
  auto add = options.add_options();
  add("seed", value(&arguments.seed), "Equal seeds give equal files");
  add("train", value(&arguments.train), "Episodes of the training bag");
  add("test", value(&arguments.test), "Episodes of the test bag");
  add("raw", value(&arguments.raw), "Pushes of the raw bag");
  add("novel", value(&arguments.novel), "Episodes of a bag with outcomes that the other bags do not have");
  add("samples", value(&arguments.samples), "Samples of an episode, 400 to 10000");
  add("raw-rate", value(&arguments.raw_rate), "[Hz] of the raw bag's wrench, 30 to 1000");
  add("threads", value(&arguments.threads), "Threads; 0: as many as the machine has");
  add("out", value(&arguments.out), "The folder to write to");
  add("help,h", "Prints these options");
  try {
    po::variables_map values;
    po::store(po::parse_command_line(argc, argv, options), values);
    if (values.count("help") > 0) {
      std::cout << options;
      return 0;
    }
    po::notify(values);
    arguments.Check();
  } catch (const std::exception& error) {
    std::cerr << "switch_push_dataset: " << error.what() << " (--help says more)\n";
    return 2;
  }
  try {
    contact_shapelets::simulation::WriteAll(arguments);
  } catch (const std::exception& error) {
    std::cerr << "switch_push_dataset: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
