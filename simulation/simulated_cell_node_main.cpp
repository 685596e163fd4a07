#include <ros/ros.h>

#include <exception>

#include "simulated_cell_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "simulated_cell_node");
  // ROS stops its log with the last handle, so one must outlive the message below.
  const ros::NodeHandle node_handle;
  try {
    contact_shapelets::simulation::SimulatedCellNode(node_handle, ros::NodeHandle("~")).Run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
