#include <gtest/gtest.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "contact_shapelets_test");
  // This handle keeps the connections of the tests open.
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
