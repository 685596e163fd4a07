/// Drives running nodes as robots would, and measures the time from the last wrench of an episode to its diagnosis, and
/// the number of samples lost. scripts/soak.sh runs it.

#include <contact_shapelets/Diagnosis.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace {

constexpr double kLimit = 60.0;

bool WaitUntil(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kLimit);
  while (!condition() && ros::WallTime::now() < end) ros::WallDuration(0.01).sleep();
  return condition();
}

/// A driver at a fixed rate with its sequencer: a push of 0.5 s every 0.6 s.
class Robot {
 public:
  Robot(const std::string& name, double rate) : rate_(rate) {
    wrench_publisher_ = node_handle_.advertise<geometry_msgs::WrenchStamped>(name + "/wrench", 2000);
    event_publisher_ = node_handle_.advertise<contact_shapelets::EpisodeEvent>(name + "/episode_event", 10);
    diagnosis_subscriber_ = node_handle_.subscribe<contact_shapelets::Diagnosis>(
        name + "/diagnosis", 100, [this](const contact_shapelets::Diagnosis::ConstPtr& diagnosis) { Take(*diagnosis); },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }

  bool WaitForConnections() const {
    return WaitUntil([this] {
      return wrench_publisher_.getNumSubscribers() > 0 && event_publisher_.getNumSubscribers() > 0 &&
             diagnosis_subscriber_.getNumPublishers() > 0;
    });
  }

  void Send() {
    const auto period = static_cast<int>(0.6 * rate_);
    const auto position = static_cast<int>(sent_ % period);
    const ros::Time now = ros::Time::now();
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = now;
    wrench.wrench.force.z = 10.0 * std::sin(0.02 * position) + 0.01 * static_cast<double>(sent_ % 7);
    const bool last = position == period - 1;
    const ros::WallTime sent = ros::WallTime::now();
    wrench_publisher_.publish(wrench);
    ++sent_;
    if (position == period / 6) SendEdge(contact_shapelets::EpisodeEvent::OPEN, now);
    if (!last || id_.empty()) return;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      last_wrench_[id_] = sent;
    }
    SendEdge(contact_shapelets::EpisodeEvent::CLOSE, now);
  }

  std::int64_t sent() const { return sent_; }
  std::vector<double> Latencies() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return latencies_;
  }

 private:
  void SendEdge(std::uint8_t kind, const ros::Time& stamp) {
    if (kind == contact_shapelets::EpisodeEvent::OPEN) id_ = std::to_string(sent_);
    contact_shapelets::EpisodeEvent event;
    event.header.stamp = stamp;
    event.kind = kind;
    event.episode_id = id_;
    event_publisher_.publish(event);
  }

  void Take(const contact_shapelets::Diagnosis& diagnosis) {
    const ros::WallTime now = ros::WallTime::now();
    if (!diagnosis.final) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto sent = last_wrench_.find(diagnosis.episode_id);
    if (sent != last_wrench_.end()) latencies_.push_back(1000.0 * (now - sent->second).toSec());
  }

  double rate_;
  std::int64_t sent_ = 0;
  std::string id_;
  mutable std::mutex mutex_;
  std::map<std::string, ros::WallTime> last_wrench_;
  std::vector<double> latencies_;
  ros::NodeHandle node_handle_;
  ros::Publisher wrench_publisher_;
  ros::Publisher event_publisher_;
  ros::Subscriber diagnosis_subscriber_;
};

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
};

/// Reads the command line. Returns nothing, after a message, if it is wrong.
std::optional<Arguments> ReadArguments(int argc, char** argv) {
  Arguments arguments;
  namespace po = boost::program_options;
  po::options_description options("Drives the nodes in the namespaces robot0, robot1, ... and measures them");
  options.add_options()("robots", po::value(&arguments.robots), "Number of robots, 1 to 64");
  options.add_options()("rate", po::value(&arguments.rate), "[Hz] of each wrench, 10 to 2000");
  options.add_options()("seconds", po::value(&arguments.seconds), "Duration, above 0");
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

using Robots = std::vector<std::unique_ptr<Robot>>;

/// Sends wrenches of all robots for the given time. Returns how long that took [s].
double Drive(const Robots& robots, const Arguments& arguments) {
  ros::WallRate pace(arguments.rate);
  const ros::WallTime start = ros::WallTime::now();
  const auto elapsed = [&start] { return (ros::WallTime::now() - start).toSec(); };
  std::int64_t sent = 0;
  for (double time = 0.0; ros::ok() && time < arguments.seconds; time = elapsed()) {
    // After a delay, sends the missing wrenches, so that the rate holds.
    for (; static_cast<double>(sent) <= time * arguments.rate; ++sent) {
      for (const auto& robot : robots) robot->Send();
    }
    pace.sleep();
  }
  return elapsed();
}

/// Prints how many wrenches were lost, and the latencies of the diagnoses. Returns the number of wrenches lost.
std::int64_t PrintResults(const Robots& robots, const Received& received, double duration) {
  std::int64_t lost = 0;
  std::int64_t sent = 0;
  std::vector<double> latencies;
  for (std::size_t index = 0; index < robots.size(); ++index) {
    const Robot& robot = *robots[index];
    const std::string name = "robot" + std::to_string(index);
    WaitUntil([&] { return received.Of(name) >= robot.sent(); });
    lost += robot.sent() - received.Of(name);
    sent += robot.sent();
    const std::vector<double> of_robot = robot.Latencies();
    latencies.insert(latencies.end(), of_robot.begin(), of_robot.end());
  }
  std::printf("%zu robots, %.0f Hz reached for each, %" PRId64 " wrenches sent, %" PRId64
              " lost, %zu episodes diagnosed\n",
              robots.size(), static_cast<double>(sent) / duration / static_cast<double>(robots.size()), sent, lost,
              latencies.size());
  std::printf("last wrench sent to diagnosis received: median %.2f ms, p99 %.2f ms, longest %.2f ms\n",
              Quantile(latencies, 0.5), Quantile(latencies, 0.99), Quantile(latencies, 1.0));
  return lost;
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
    robots.push_back(std::make_unique<Robot>("robot" + std::to_string(index), arguments->rate));
  }
  for (const auto& robot : robots) {
    if (robot->WaitForConnections()) continue;
    std::fprintf(stderr, "live_load: not all nodes of robot0 to robot%d are there\n", arguments->robots - 1);
    return 1;
  }
  const double duration = Drive(robots, *arguments);
  return PrintResults(robots, received, duration) == 0 ? 0 : 1;
}
