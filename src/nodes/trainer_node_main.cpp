#include <ros/ros.h>

#include <csignal>
#include <string>

#include "ros/bags/bag_damage.h"
#include "ros/nodes/trainer_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "trainer_node");
  // ROS handles only SIGINT. A training must end cleanly on SIGTERM too.
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
  // Otherwise errors about damaged bags would not reach ROS's log.
  contact_shapelets::BagLog log([](const std::string& text) { ROS_WARN("%s", text.c_str()); });
  contact_shapelets::TrainerNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  // Serves diagnostics and goals during the training at the start.
  ros::AsyncSpinner spinner(2);
  spinner.start();
  node.TrainAtStart();
  ros::waitForShutdown();
  return 0;
}
