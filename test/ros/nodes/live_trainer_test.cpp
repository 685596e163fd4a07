/// The trainer node's action: results, feedback, cancelling, failures.

#include <actionlib/client/simple_action_client.h>
#include <contact_shapelets/Episode.h>
#include <contact_shapelets/ShapeletModel.h>
#include <contact_shapelets/TrainAction.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "contact_shapelets/ros/model_bag.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

using actionlib::SimpleClientGoalState;
using Client = actionlib::SimpleActionClient<TrainAction>;

std::string PathParameter(const std::string& name) {
  std::string path;
  EXPECT_TRUE(ros::param::get("/paths/" + name, path)) << name;
  return path;
}

std::string Contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TrainGoal GoalTo(const std::string& output) {
  TrainGoal goal;
  goal.bags = {PathParameter("bags") + "/switch_push_test.bag"};
  goal.output = output;
  goal.clusters = 3;
  return goal;
}

/// A copy of a model. No training may change it.
std::string OldModel() {
  std::string path = testing::TempDir() + "old_model.bag";
  std::ofstream(path, std::ios::binary) << Contents(PathParameter("model"));
  return path;
}

bool Finished(Client* client) {
  return WaitUntil([client] { return client->getState().isDone(); }, 2.0 * kLimit);
}

TEST(Trainer, TrainsReportsProgressAndPublishesTheModel) {
  Client client("quick/train", true);
  Inbox<ShapeletModel> models("quick/model");
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  const std::string output = testing::TempDir() + "trained_model.bag";
  std::mutex mutex;
  std::vector<TrainFeedback> feedback;
  client.sendGoal(GoalTo(output), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                  [&](const TrainFeedbackConstPtr& step) {
                    const std::lock_guard<std::mutex> lock(mutex);
                    feedback.push_back(*step);
                  });
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::SUCCEEDED) << client.getResult()->message;
  const TrainResult result = *client.getResult();
  EXPECT_TRUE(result.success);
  EXPECT_EQ(result.episodes, 45U);
  EXPECT_GT(result.rand_index, 0.5F);
  EXPECT_EQ(LoadModel(output).id, result.model_id);
  ASSERT_TRUE(models.WaitForCount(1));
  EXPECT_EQ(models.messages().back().model_id, result.model_id);
  const std::lock_guard<std::mutex> lock(mutex);
  ASSERT_GE(feedback.size(), 2U);
  EXPECT_LT(feedback.front().fraction_done, feedback.back().fraction_done);
  EXPECT_LE(feedback.back().fraction_done, 1.0F);
}

TEST(Trainer, TrainsThePapersSetUpByPaperYaml) {
  Client client("paper/train", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  const std::string output = testing::TempDir() + "paper_model.bag";
  client.sendGoal(GoalTo(output));
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::SUCCEEDED) << client.getResult()->message;
  const core::Model model = LoadModel(output);
  EXPECT_EQ(model.provenance.objective, "paper");
  EXPECT_EQ(model.provenance.selected_scales, std::vector<double>{0.4});
  EXPECT_EQ(model.log_offset, 0.0);
}

TEST(Trainer, LeavesOutEpisodesThatLackSamplesAndCountsThem) {
  const std::string recording = testing::TempDir() + "incomplete.bag";
  {
    const rosbag::Bag input(PathParameter("bags") + "/switch_push_test.bag", rosbag::bagmode::Read);
    rosbag::Bag output(recording, rosbag::bagmode::Write);
    rosbag::View view(input, rosbag::TypeQuery("contact_shapelets/Episode"));
    int count = 0;
    for (const rosbag::MessageInstance& message : view) {
      Episode episode = *message.instantiate<Episode>();
      episode.complete = ++count % 9 == 0 ? 0U : 1U;
      output.write(message.getTopic(), message.getTime(), episode);
    }
  }
  Client client("quick/train", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  TrainGoal goal = GoalTo(testing::TempDir() + "of_complete_ones.bag");
  goal.bags = {recording};
  client.sendGoal(goal);
  ASSERT_TRUE(Finished(&client));
  const TrainResult result = *client.getResult();
  EXPECT_TRUE(result.success) << result.message;
  EXPECT_EQ(result.episodes, 40U);
  EXPECT_EQ(result.incomplete, 5U);
  EXPECT_NE(result.message.find("5 incomplete ones left out"), std::string::npos) << result.message;
}

TEST(Trainer, LeavesACoreToTheCell) {
  Diagnostics diagnostics;
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  EXPECT_TRUE(diagnostics.WaitForValue("quick/trainer_node", "threads", std::to_string(threads)));
}

TEST(Trainer, CancelledLeavesTheOldModel) {
  Client client("slow/train", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  const std::string output = OldModel();
  const std::string before = Contents(output);
  std::atomic<int> steps{0};
  client.sendGoal(GoalTo(output), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                  [&](const TrainFeedbackConstPtr& step) {
                    if (step->step > 0) ++steps;
                  });
  ASSERT_TRUE(WaitUntil([&] { return steps > 0; }));
  client.cancelGoal();
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::PREEMPTED);
  EXPECT_FALSE(client.getResult()->success);
  EXPECT_EQ(Contents(output), before);
}

TEST(Trainer, FailedLeavesTheOldModelAndSaysWhy) {
  Client client("quick/train", true);
  Diagnostics diagnostics;
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  const std::string output = OldModel();
  const std::string before = Contents(output);
  TrainGoal goal = GoalTo(output);
  goal.bags.push_back("/no/such/day.bag");
  client.sendGoal(goal);
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::ABORTED);
  EXPECT_NE(client.getResult()->message.find("/no/such/day.bag"), std::string::npos) << client.getResult()->message;
  EXPECT_EQ(Contents(output), before);
  EXPECT_TRUE(diagnostics.WaitFor("quick/trainer_node", diagnostic_msgs::DiagnosticStatus::ERROR, "/no/such/day.bag"));
}

TEST(Trainer, RefusesMoreClustersThanEpisodes) {
  Client client("quick/train", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  TrainGoal goal = GoalTo(OldModel());
  goal.clusters = 46;
  client.sendGoal(goal);
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::ABORTED);
  EXPECT_NE(client.getResult()->message.find("fewer episodes (45) than clusters (46)"), std::string::npos);
}

TEST(Trainer, RefusesAnOutputBeforeItTrains) {
  // This training would never end.
  Client client("slow/train", true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  const std::string recording = testing::TempDir() + "recording.bag";
  const std::string before = Contents(PathParameter("bags") + "/switch_push_raw.bag");
  std::ofstream(recording, std::ios::binary) << before;
  const std::vector<std::pair<std::string, std::string>> cases{
      {recording, "found another bag"}, {"/no/such/folder/model.bag", "there is no folder"}, {"", "it is empty"}};
  for (const auto& [output, fault] : cases) {
    client.sendGoal(GoalTo(output));
    ASSERT_TRUE(Finished(&client));
    EXPECT_EQ(client.getState(), SimpleClientGoalState::ABORTED);
    EXPECT_NE(client.getResult()->message.find(fault), std::string::npos) << client.getResult()->message;
  }
  EXPECT_EQ(Contents(recording), before);
}

TEST(Trainer, RefusesGoalsWhileParametersAreOutOfRange) {
  Client client("faulty/train", true);
  Diagnostics diagnostics;
  ASSERT_TRUE(client.waitForServer(ros::Duration(kLimit)));
  EXPECT_TRUE(diagnostics.WaitFor("faulty/trainer_node", diagnostic_msgs::DiagnosticStatus::ERROR, "novelty_margin"));
  const std::string output = OldModel();
  client.sendGoal(GoalTo(output));
  ASSERT_TRUE(Finished(&client));
  EXPECT_EQ(client.getState(), SimpleClientGoalState::ABORTED);
  EXPECT_NE(client.getResult()->message.find("novelty_margin"), std::string::npos) << client.getResult()->message;
}

}  // namespace
}  // namespace contact_shapelets::test
