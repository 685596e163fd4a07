/// Drives running nodes as robots would. It measures the time from the last wrench of an episode to its diagnosis,
/// counts the samples lost, and compares every episode with what was sent. scripts/soak.sh runs it.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "driven_robot.h"
#include "wait.h"

namespace {

using contact_shapelets::benchmark::ClockFaults;
using contact_shapelets::benchmark::DrivenRobot;
using contact_shapelets::benchmark::Outcome;
using contact_shapelets::benchmark::WaitUntil;

/// The number of samples that each episode node says it has received.
class Received {
 public:
  Received()
      : subscriber_(node_handle_.subscribe<diagnostic_msgs::DiagnosticArray>(
            "/diagnostics", 100, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& array) {
              const std::lock_guard<std::mutex> lock(mutex_);
              for (const auto& status : array->status) {
                for (const auto& entry : status.values) {
                  if (entry.key != "samples") continue;
                  samples_[status.name.substr(0, status.name.find('/'))] = std::stoll(entry.value);
                }
              }
            })) {}
  std::int64_t Of(const std::string& robot) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = samples_.find(robot);
    return found == samples_.end() ? 0 : found->second;
  }

 private:
  ros::NodeHandle node_handle_;
  mutable std::mutex mutex_;
  std::map<std::string, std::int64_t> samples_;
  ros::Subscriber subscriber_;
};

double Quantile(std::vector<double> values, double part) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

struct Arguments {
  int robots = 1;
  double rate = 1000.0;
  double seconds = 120.0;
  bool faults = false;
};

/// Reads the command line. Returns nothing, after a message, if it is wrong.
std::optional<Arguments> ReadArguments(int argc, char** argv) {
  Arguments arguments;
  namespace po = boost::program_options;
  po::options_description options("Drives the nodes in the namespaces robot0, robot1, ... and measures them");
  options.add_options()("robots", po::value(&arguments.robots), "Number of robots, 1 to 64");
  options.add_options()("rate", po::value(&arguments.rate), "[Hz] of each wrench, 10 to 2000");
  options.add_options()("seconds", po::value(&arguments.seconds), "Duration, above 0");
  options.add_options()("faults", po::bool_switch(&arguments.faults),
                        "Let each driver's clock drift by 100 ppm and be set by 0.4 s, and each driver restart");
  try {
    po::variables_map values;
    po::store(po::parse_command_line(argc, argv, options), values);
    po::notify(values);
  } catch (const po::error& error) {
    std::cerr << "live_load: " << error.what() << '\n' << options;
    return std::nullopt;
  }
  const bool valid = arguments.robots >= 1 && arguments.robots <= 64 && arguments.rate >= 10.0 &&
                     arguments.rate <= 2000.0 && arguments.seconds > 0.0;
  if (valid) return arguments;
  std::cerr << "live_load: a value is out of range\n" << options;
  return std::nullopt;
}

using Robots = std::vector<std::unique_ptr<DrivenRobot>>;

/// The faults of a robot: its own times, so that they meet pushes and the time between them.
ClockFaults FaultsOf(int robot, const Arguments& arguments) {
  ClockFaults faults;
  if (!arguments.faults) return faults;
  faults.drift = robot % 4 < 2 ? 1e-4 : -1e-4;
  faults.step = 0.4;
  faults.step_at = arguments.seconds / 3.0 + 0.17 * robot;
  faults.restart_at = 2.0 * arguments.seconds / 3.0 + 0.17 * robot;
  return faults;
}

/// Sends wrenches of all robots for the given time. Returns the rate that was reached [Hz].
double Drive(const Robots& robots, const Arguments& arguments) {
  ros::WallRate pace(arguments.rate);
  const ros::WallTime start = ros::WallTime::now();
  const auto elapsed = [&start] { return (ros::WallTime::now() - start).toSec(); };
  std::int64_t ticks = 0;
  for (double time = 0.0; ros::ok() && time < arguments.seconds; time = elapsed()) {
    // After a delay, sends the missing wrenches, so that the rate holds.
    for (; static_cast<double>(ticks) <= time * arguments.rate; ++ticks) {
      for (const auto& robot : robots) robot->Send(static_cast<double>(ticks) / arguments.rate, elapsed());
    }
    pace.sleep();
  }
  return static_cast<double>(ticks) / elapsed();
}

/// Prints how many wrenches were lost, and the latencies of the diagnoses. Returns the number of wrenches lost.
std::int64_t PrintLoad(const Robots& robots, const Received& received, double rate) {
  const auto count_lost = [&] {
    std::int64_t lost = 0;
    for (std::size_t index = 0; index < robots.size(); ++index) {
      lost += std::abs(robots[index]->sent() - received.Of("robot" + std::to_string(index)));
    }
    return lost;
  };
  WaitUntil([&] { return count_lost() == 0; });
  const std::int64_t lost = count_lost();
  std::int64_t sent = 0;
  std::vector<double> latencies;
  for (const auto& robot : robots) {
    sent += robot->sent();
    const std::vector<double> of_robot = robot->Latencies();
    latencies.insert(latencies.end(), of_robot.begin(), of_robot.end());
  }
  std::printf("%zu robots, %.0f Hz reached for each, %" PRId64 " wrenches sent, %" PRId64
              " lost, %zu episodes diagnosed\n",
              robots.size(), rate, sent, lost, latencies.size());
  std::printf("last wrench sent to diagnosis received: median %.2f ms, p99 %.2f ms, longest %.2f ms\n",
              Quantile(latencies, 0.5), Quantile(latencies, 0.99), Quantile(latencies, 1.0));
  return lost;
}

/// Prints how the episodes compare with the pushes. Returns the number of those that are wrong or lost.
int PrintEpisodes(const Robots& robots) {
  Outcome sum;
  WaitUntil([&] {
    return std::all_of(robots.begin(), robots.end(), [](const auto& robot) { return robot->HasLastEpisode(); });
  });
  for (const auto& robot : robots) {
    const Outcome outcome = robot->Compare();
    sum.right += outcome.right;
    sum.wrong += outcome.wrong;
    sum.incomplete += outcome.incomplete;
    sum.lost += outcome.lost;
    sum.greatest_error = std::max(sum.greatest_error, outcome.greatest_error);
    sum.greatest_part = std::max(sum.greatest_part, outcome.greatest_part);
  }
  std::printf(
      "pushes: %d right, %d wrong, %d incomplete across a fault, %d lost; edges off by %.2f ms at most, %.0f %% "
      "of the tolerance\n",
      sum.right, sum.wrong, sum.incomplete, sum.lost, 1000.0 * sum.greatest_error, 100.0 * sum.greatest_part);
  return sum.wrong + sum.lost;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "live_load");
  const std::optional<Arguments> arguments = ReadArguments(argc, argv);
  if (!arguments) return 2;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const Received received;
  Robots robots;
  for (int index = 0; index < arguments->robots; ++index) {
    // Every other robot has plain edges.
    robots.push_back(std::make_unique<DrivenRobot>("robot" + std::to_string(index), arguments->rate, index % 2 == 0,
                                                   FaultsOf(index, *arguments)));
  }
  for (const auto& robot : robots) {
    if (robot->WaitForConnections()) continue;
    std::fprintf(stderr, "live_load: not all nodes of robot0 to robot%d are there\n", arguments->robots - 1);
    return 1;
  }
  const double rate = Drive(robots, *arguments);
  const int bad_episodes = PrintEpisodes(robots);
  const std::int64_t lost = PrintLoad(robots, received, rate);
  return lost == 0 && bad_episodes == 0 ? 0 : 1;
}
