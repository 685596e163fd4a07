#include <gtest/gtest.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "contact_shapelets_test");
  // While one handle lives, the connections of the tests stay up.
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
