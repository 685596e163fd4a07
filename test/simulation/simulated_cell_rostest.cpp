#include <contact_shapelets/PushSwitch.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <functional>
#include <string>
#include <vector>

namespace contact_shapelets {
namespace {

/// Takes messages until `done` returns true. Returns false if that takes more than a minute of wall time.
bool WaitFor(const std::function<bool()>& done) {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(60.0);
  while (!done()) {
    if (!ros::ok() || ros::WallTime::now() > limit) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  }
  return true;
}

PushSwitch Push(const std::string& outcome) {
  PushSwitch push;
  push.request.outcome = outcome;
  EXPECT_TRUE(ros::service::call("cell/push", push));
  return push;
}

TEST(SimulatedCellNode, PushesOnceWhenTheServiceIsCalled) {
  ros::NodeHandle node_handle;
  std::vector<bool> edges;
  std::string outcome;
  std::vector<ros::Time> stamps;
  const ros::Subscriber active = node_handle.subscribe<std_msgs::Bool>(
      "episode_active", 10, [&](const std_msgs::BoolConstPtr& message) { edges.push_back(message->data != 0); });
  const ros::Subscriber outcomes = node_handle.subscribe<std_msgs::String>(
      "outcome", 10, [&](const std_msgs::StringConstPtr& message) { outcome = message->data; });
  const ros::Subscriber wrench = node_handle.subscribe<geometry_msgs::WrenchStamped>(
      "wrench", 5000,
      [&](const geometry_msgs::WrenchStampedConstPtr& message) { stamps.push_back(message->header.stamp); });
  ASSERT_TRUE(ros::service::waitForService("cell/push", ros::Duration(60.0)));
  ASSERT_TRUE(WaitFor([&] {
    return active.getNumPublishers() > 0 && outcomes.getNumPublishers() > 0 && wrench.getNumPublishers() > 0;
  }));

  const PushSwitch unknown = Push("exploded");
  EXPECT_FALSE(unknown.response.success);
  EXPECT_NE(unknown.response.message.find("exploded"), std::string::npos);

  const PushSwitch accepted = Push("already_on");
  EXPECT_TRUE(accepted.response.success) << accepted.response.message;
  EXPECT_FALSE(Push("switched").response.success) << "a second push began during the first";

  ASSERT_TRUE(WaitFor([&] { return !outcome.empty(); }));
  EXPECT_EQ(outcome, "already_on");
  EXPECT_EQ(edges, (std::vector<bool>{true, false}));
  ASSERT_GT(stamps.size(), 800U);
  EXPECT_NEAR((stamps.back() - stamps.front()).toSec() / static_cast<double>(stamps.size() - 1), 1.0 / 200.0, 1e-5);
}

}  // namespace
}  // namespace contact_shapelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulated_cell_rostest");
  const ros::NodeHandle node_handle;
  return RUN_ALL_TESTS();
}
