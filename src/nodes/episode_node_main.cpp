#include <ros/ros.h>

#include "ros/nodes/episode_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "episode_node");
  contact_shapelets::EpisodeNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  node.Run();
  return 0;
}
