#include "simulated_cell_node.h"

#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "ros/messages/names.h"
#include "wrench_message.h"

namespace contact_shapelets::simulation {
namespace {

constexpr double kBefore = 1.2;        // [s] in which the arm goes to the start of a push
constexpr double kOutcomeDelay = 0.3;  // [s] from the episode's end to the outcome
constexpr double kGreatestLag = 0.2;   // [s] the cell catches up with a lag up to this, and skips a greater one

SimulatedCellOptions CheckedOptions(const ros::NodeHandle& node_handle) {
  ParameterReader reader(node_handle);
  SimulatedCellOptions options = ReadSimulatedCellOptions(&reader);
  for (const std::string& name : reader.Unread()) reader.AddFaults(name + " is not a parameter of this node\n");
  if (!reader.Faults().empty()) throw std::invalid_argument(reader.Faults());
  return options;
}

}  // namespace

std::string SimulatedCellOptions::Faults() const {
  std::ostringstream faults;
  const auto check = [&faults](bool valid, const char* name, const char* range, double value) {
    if (!valid) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  check(rate >= 30.0 && rate <= 1000.0, "rate", "in [30, 1000] Hz", rate);
  check(episode_duration >= 4.0 && episode_duration <= 20.0, "episode_duration", "in [4, 20] s", episode_duration);
  check(period >= episode_duration + 2.0 && period <= 3600.0, "period",
        "at least 2 s above episode_duration and at most 3600 s", period);
  check(seed >= 0, "seed", "at least 0", seed);
  check(speed >= 0.01 && speed <= 100.0, "speed", "in [0.01, 100]", speed);
  check(publish_clock || speed == 1.0, "speed", "1 if publish_clock is false", speed);
  for (const std::string& word : script) {
    try {
      OutcomeOfName(word);
    } catch (const std::invalid_argument& error) {
      faults << "script: " << error.what() << '\n';
    }
  }
  return faults.str();
}

SimulatedCellOptions ReadSimulatedCellOptions(ParameterReader* reader) {
  SimulatedCellOptions options;
  reader->Read("rate", &options.rate);
  reader->Read("script", &options.script);
  reader->Read("endless", &options.endless);
  reader->Read("period", &options.period);
  reader->Read("episode_duration", &options.episode_duration);
  reader->Read("seed", &options.seed);
  reader->Read("publish_clock", &options.publish_clock);
  reader->Read("speed", &options.speed);
  reader->AddFaults(options.Faults());
  return options;
}

SimulatedCellNode::SimulatedCellNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle)
    : node_handle_(node_handle),
      private_node_handle_(private_node_handle),
      options_(CheckedOptions(private_node_handle)),
      random_(static_cast<std::uint64_t>(options_.seed)),
      cell_(SamplePushCondition(Outcome::kSwitched, &random_)) {
  wrench_publisher_ = node_handle_.advertise<geometry_msgs::WrenchStamped>(topics::kWrench, topics::kWrenchQueue);
  active_publisher_ = node_handle_.advertise<std_msgs::Bool>(topics::kEpisodeActive, topics::kEdgeQueue);
  outcome_publisher_ = node_handle_.advertise<std_msgs::String>(topics::kOutcome, topics::kEdgeQueue);
  push_service_ = private_node_handle_.advertiseService("push", &SimulatedCellNode::OnPush, this);
  if (options_.publish_clock) clock_publisher_ = node_handle_.advertise<rosgraph_msgs::Clock>("/clock", 10);
}

void SimulatedCellNode::Run() {
  // The node's own clock begins at a fixed time, so that the stamps of two recordings match.
  if (options_.publish_clock) {
    origin_ = ros::Time(1000.0);
  } else if (!ros::Time::waitForValid()) {
    return;
  } else {
    origin_ = ros::Time::now();
  }
  wall_origin_ = ros::WallTime::now();
  ros::WallRate cycle(1000.0);
  while (node_handle_.ok()) {
    AdvanceTo(TargetTime());
    ros::spinOnce();
    cycle.sleep();
  }
}

double SimulatedCellNode::TargetTime() {
  const double passed = options_.publish_clock ? options_.speed * (ros::WallTime::now() - wall_origin_).toSec()
                                               : (ros::Time::now() - origin_).toSec();
  const double lag = passed - cell_.state().time;
  const bool jumped_back = lag < -kGreatestLag;
  if (!jumped_back && lag <= kGreatestLag * std::max(1.0, options_.speed)) return passed;
  ROS_WARN_THROTTLE(10.0, "The clock is %.3f s %s the simulated cell; the cell goes on from the clock's time",
                    std::abs(lag), jumped_back ? "behind" : "ahead of");
  // The node's own clock goes on without a gap. Stamps must follow a foreign clock.
  if (options_.publish_clock) {
    wall_origin_ += ros::WallDuration(lag / options_.speed);
  } else {
    origin_ += ros::Duration(lag);
  }
  return cell_.state().time;
}

void SimulatedCellNode::AdvanceTo(double time) {
  while (cell_.state().time + SimulatedCell::kPeriod <= time && node_handle_.ok()) Cycle();
}

void SimulatedCellNode::Cycle() {
  const CellState& state = cell_.Step();
  if (options_.publish_clock) PublishClock();
  // A tolerance of half a cycle keeps rounding from skipping a message.
  if ((state.time + 0.5 * SimulatedCell::kPeriod) * options_.rate >= static_cast<double>(published_)) {
    wrench_publisher_.publish(WrenchMessage(state, StampOf(state.time)));
    published_ = static_cast<std::int64_t>(std::floor((state.time + 0.5 * SimulatedCell::kPeriod) * options_.rate)) + 1;
  }
  AdvanceStage();
}

void SimulatedCellNode::AdvanceStage() {
  const double time = cell_.state().time;
  if (stage_ == Stage::kRest) {
    if (options_.endless && time >= next_push_) BeginPush(NextOutcome());
    return;
  }
  if (time < stage_end_) return;
  if (stage_ == Stage::kBefore) {
    PublishActive(true);
    cell_.BeginPush();
    stage_ = Stage::kEpisode;
    stage_end_ = time + options_.episode_duration;
  } else if (stage_ == Stage::kEpisode) {
    PublishActive(false);
    stage_ = Stage::kAfter;
    stage_end_ = time + kOutcomeDelay;
  } else if (cell_.ObservedOutcome()) {
    PublishOutcome();
    stage_ = Stage::kRest;
  }
}

void SimulatedCellNode::BeginPush(Outcome outcome) {
  const double time = cell_.state().time;
  cell_.SetUp(SamplePushCondition(outcome, &random_));
  next_push_ = time + options_.period;
  stage_ = Stage::kBefore;
  stage_end_ = time + kBefore;
}

Outcome SimulatedCellNode::NextOutcome() {
  const auto& outcomes = AllOutcomes();
  if (options_.script.empty()) {
    return outcomes[static_cast<std::size_t>(random_.Index(static_cast<int>(outcomes.size())))];
  }
  return OutcomeOfName(options_.script[script_place_++ % options_.script.size()]);
}

bool SimulatedCellNode::OnPush(PushSwitch::Request& request, PushSwitch::Response& response) {
  if (stage_ != Stage::kRest) {
    response.message = "a push is going on";
    return true;
  }
  try {
    const Outcome outcome = request.outcome.empty() ? NextOutcome() : OutcomeOfName(request.outcome);
    BeginPush(outcome);
    response.success = 1U;
    response.message = NameOf(outcome);
  } catch (const std::invalid_argument& error) {
    response.message = error.what();
  }
  return true;
}

void SimulatedCellNode::PublishActive(bool active) {
  std_msgs::Bool message;
  message.data = active ? 1U : 0U;
  active_publisher_.publish(message);
}

void SimulatedCellNode::PublishOutcome() {
  std_msgs::String message;
  message.data = NameOf(*cell_.ObservedOutcome());
  outcome_publisher_.publish(message);
  ROS_INFO("Push: %s", message.data.c_str());
}

void SimulatedCellNode::PublishClock() {
  rosgraph_msgs::Clock message;
  message.clock = StampOf(cell_.state().time);
  clock_publisher_.publish(message);
}

}  // namespace contact_shapelets::simulation
