#pragma once

#include <contact_shapelets/Diagnosis.h>
#include <contact_shapelets/Episode.h>
#include <ros/ros.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace contact_shapelets::benchmark {

/// What the driver's clock does; times are in seconds of the run.
struct ClockFaults {
  double drift = 0.0;  ///< [s/s] against this machine's clock
  double step = 0.0;   ///< [s] by which it is set at `step_at`
  double step_at = 1e9;
  double restart_at = 1e9;  ///< the driver restarts: its stream pauses, and its clock begins anew
  double pause = 1.0;       ///< [s] without a wrench from `restart_at` on
};

/// How many pushes became which episodes.
struct Outcome {
  int right = 0;                ///< complete, with the samples between the edges
  int wrong = 0;                ///< complete, but with other samples
  int incomplete = 0;           ///< marked so, where a fault touched the push
  int lost = 0;                 ///< no episode, an incomplete one or two, where no fault touched the push
  double greatest_error = 0.0;  ///< [s] of an edge of a complete episode
  double greatest_part = 0.0;   ///< of the tolerance that such an error took
};

/// A driver at a fixed rate with its sequencer: a push of 0.5 s every 0.6 s. It knows which samples lie between its
/// edges.
class DrivenRobot {
 public:
  /// Publishes in the namespace `name` at `rate` [Hz]; edges are stamped or plain.
  DrivenRobot(const std::string& name, double rate, bool stamped, const ClockFaults& faults);

  /// Waits until the nodes are connected; false if they are not within a minute.
  bool WaitForConnections() const;
  /// Publishes the next wrench, and its edge if it has one. It is due at `due` [s] and sent at `now`.
  void Send(double due, double now);
  /// Whether the episode of the last push has come.
  bool HasLastEpisode() const;

  /// Number of wrenches sent.
  std::int64_t sent() const { return static_cast<std::int64_t>(samples_.size()); }
  /// From the last wrench of each push to its diagnosis [ms].
  std::vector<double> Latencies() const;
  /// Compares the episodes with the pushes, and prints each that is wrong or lost.
  Outcome Compare() const;

 private:
  struct Sample {
    std::int64_t stamp = 0;  ///< [ns]
    double force = 0.0;
    double time = 0.0;      ///< when it was sent
    double lateness = 0.0;  ///< what it was sent after it was due
  };
  /// Numbers of the samples at its edges.
  struct Push {
    std::size_t open = 0;
    std::size_t close = 0;
    ros::WallTime end;  ///< when the last wrench was sent
  };
  struct Arrived {
    std::int64_t stamp = 0;
    ros::WallTime time;
  };

  std::int64_t Stamp(double now) const;
  void SendEdge(bool open, std::int64_t stamp);
  std::size_t PushAt(std::int64_t stamp) const;
  bool IsTouched(const Push& push) const;
  double Tolerance(const Push& push) const;
  bool HasForce(float force, std::int64_t from, double tolerance, const Push& push) const;
  void Judge(const Push& push, const std::vector<Episode>& episodes, Outcome* outcome) const;

  std::string name_;
  double rate_;
  bool stamped_;
  ClockFaults faults_;
  std::int64_t start_;
  std::vector<Sample> samples_;
  std::vector<Push> pushes_;
  std::optional<std::size_t> open_;
  mutable std::mutex mutex_;
  std::vector<Arrived> diagnoses_;
  std::vector<Episode> episodes_;
  ros::NodeHandle node_handle_;
  ros::Publisher wrench_publisher_;
  ros::Publisher edge_publisher_;
  ros::Subscriber diagnosis_subscriber_;
  ros::Subscriber episode_subscriber_;
};

}  // namespace contact_shapelets::benchmark
