#pragma once

#include <contact_shapelets/PushSwitch.h>
#include <ros/ros.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/numerics/random.h"
#include "ros/parameters/parameters.h"
#include "simulated_cell.h"

namespace contact_shapelets::simulation {

/// Parameters of the node.
struct SimulatedCellOptions {
  double rate = 1000.0;             ///< [Hz] of the wrench, [30, 1000]
  std::vector<std::string> script;  ///< outcomes of the pushes in turn; empty: random outcomes
  bool endless = true;              ///< push again and again; false: only when the service is called
  double period = 7.0;              ///< [s] from one push to the next, at least 2 above the episode's duration
  double episode_duration = 4.33;   ///< [s], [4, 20]
  int seed = 1;                     ///< seed of conditions and noise, at least 0
  bool publish_clock = false;       ///< publish /clock, for use_sim_time
  double speed = 1.0;               ///< simulated seconds per second, [0.01, 100]; 1 without `publish_clock`

  /// Returns one line for each invalid parameter, with its name and range; an empty string if all values are valid.
  std::string Faults() const;
};

/// Reads the parameters of the node and adds their faults to `reader`.
SimulatedCellOptions ReadSimulatedCellOptions(ParameterReader* reader);

/// The simulated cell as a node. It publishes what a robot's driver and a sequencer would: wrench, episode_active,
/// outcome.
class SimulatedCellNode {
 public:
  /// Reads parameters from `private_node_handle`, then sets up publishers and the service.
  /// \throws std::invalid_argument that names every invalid parameter.
  SimulatedCellNode(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_node_handle);

  /// Simulates in step with the clock until the node shuts down.
  void Run();

 private:
  enum class Stage { kRest, kBefore, kEpisode, kAfter };

  bool OnPush(PushSwitch::Request& request, PushSwitch::Response& response);
  void AdvanceTo(double time);
  void Cycle();
  void AdvanceStage();
  void BeginPush(Outcome outcome);
  Outcome NextOutcome();
  void PublishActive(bool active);
  void PublishOutcome();
  void PublishClock();
  ros::Time StampOf(double time) const { return origin_ + ros::Duration(time); }
  /// Returns the time [s] that the cell should have reached by now.
  double TargetTime();

  ros::NodeHandle node_handle_;
  ros::NodeHandle private_node_handle_;
  SimulatedCellOptions options_;
  core::Random random_;
  SimulatedCell cell_;
  Stage stage_ = Stage::kRest;
  double stage_end_ = 1.0;  ///< [s] of the cell's time
  double next_push_ = 1.0;  ///< [s] of the cell's time
  std::int64_t published_ = 0;
  std::size_t script_place_ = 0;
  ros::Time origin_;  ///< stamp of the cell's time 0
  ros::WallTime wall_origin_;
  ros::Publisher wrench_publisher_;
  ros::Publisher active_publisher_;
  ros::Publisher outcome_publisher_;
  ros::Publisher clock_publisher_;
  ros::ServiceServer push_service_;
};

}  // namespace contact_shapelets::simulation
