#include <ros/ros.h>

#include "ros/nodes/episode_node.h"
#include "ros/nodes/standby.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "episode_node");
  // record.launch and diagnose.launch both start this node.
  contact_shapelets::WaitForName();
  contact_shapelets::EpisodeNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  node.Run();
  return 0;
}
