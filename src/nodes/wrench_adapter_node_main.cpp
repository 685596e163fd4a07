#include <ros/ros.h>

#include "ros/nodes/wrench_adapter_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "wrench_adapter_node");
  contact_shapelets::WrenchAdapterNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
  return 0;
}
