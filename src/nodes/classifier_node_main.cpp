#include <ros/ros.h>

#include "ros/nodes/classifier_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "classifier_node");
  contact_shapelets::ClassifierNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
  return 0;
}
