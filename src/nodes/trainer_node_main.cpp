#include <ros/ros.h>

#include <csignal>
#include <string>

#include "ros/bags/bag_damage.h"
#include "ros/nodes/trainer_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "trainer_node");
  // ROS handles SIGINT alone; a training ends in good order on both.
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
  // ROS's log does not hear of damaged bags otherwise.
  contact_shapelets::BagLog log([](const std::string& text) { ROS_WARN("%s", text.c_str()); });
  contact_shapelets::TrainerNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  // Diagnostics and goals go on while a training at the start runs.
  ros::AsyncSpinner spinner(2);
  spinner.start();
  node.TrainAtStart();
  ros::waitForShutdown();
  return 0;
}
