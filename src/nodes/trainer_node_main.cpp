#include <console_bridge/console.h>
#include <ros/ros.h>

#include <csignal>
#include <string>

#include "contact_shapelets/ros/trainer_node.h"

namespace {

/// Passes on what is said of damaged bags, while this exists: ROS's log does not hear of it otherwise.
class RosLog : public console_bridge::OutputHandler {
 public:
  RosLog() : outer_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~RosLog() override { console_bridge::useOutputHandler(outer_); }
  RosLog(const RosLog&) = delete;
  RosLog& operator=(const RosLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/, int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) ROS_WARN("%s", text.c_str());
  }

 private:
  console_bridge::OutputHandler* outer_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "trainer_node");
  // ROS handles SIGINT alone; a training ends in good order on both.
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
  RosLog log;
  contact_shapelets::TrainerNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  // Diagnostics and goals go on while a training at the start runs.
  ros::AsyncSpinner spinner(2);
  spinner.start();
  node.TrainAtStart();
  ros::waitForShutdown();
  return 0;
}
