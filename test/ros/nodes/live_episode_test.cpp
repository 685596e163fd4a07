/// Live segmentation by the episode node: wrench, triggers, services and bad input.

#include <actionlib_msgs/GoalStatusArray.h>
#include <contact_shapelets/Episode.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <contact_shapelets/Tare.h>
#include <gtest/gtest.h>
#include <ros/network.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cmath>
#include <csignal>
#include <limits>

#include "contact_shapelets/ros/episode_bag_reader.h"
#include "ros/bags/bag_fixture.h"
#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// Plays one second of stream with a contact of 20 N from 0.3 s to 0.6 s.
double Contact(double time) { return time > 0.3 && time < 0.6 ? 20.0 : 0.0; }

std_srvs::Trigger::Response Call(const std::string& service) {
  std_srvs::Trigger trigger;
  EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(kLimit)));
  EXPECT_TRUE(ros::service::call(service, trigger)) << service;
  return trigger.response;
}

float Greatest(const Episode& episode) {
  return episode.force.empty() ? 0.0F : *std::max_element(episode.force.begin(), episode.force.end());
}

/// A publisher that knows when the node listens.
template <typename Message>
class Sequencer {
 public:
  explicit Sequencer(const std::string& topic) : publisher_(node_handle_.advertise<Message>(topic, 100)) {}
  bool WaitForSubscriber() {
    return WaitUntil([this] { return publisher_.getNumSubscribers() > 0; });
  }
  void Publish(const Message& message) { publisher_.publish(message); }

 private:
  ros::NodeHandle node_handle_;
  ros::Publisher publisher_;
};

/// Where the master says that a node is; each process has its own place.
std::string UriOf(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = ros::names::resolve(node);
  return ros::master::execute("lookupNode", request, response, uri, false) ? std::string(uri) : "";
}

/// Ends a node as a crash does, and waits for the one that takes its place.
bool WaitForRespawn(const std::string& node) {
  const std::string uri = UriOf(node);
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return false;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  request[0] = ros::this_node::getName();
  if (!client.execute("getPid", request, response) || response.size() != 3) return false;
  kill(static_cast<int>(response[2]), SIGKILL);
  return WaitUntil([&] { return UriOf(node) != uri; });
}

std_msgs::Bool Active(bool active) {
  std_msgs::Bool message;
  message.data = active ? 1U : 0U;
  return message;
}

TEST(TriggerSegmentation, CutsBetweenUnstampedEdgesAndPublishesStampedOnes) {
  Inbox<Episode> episodes("plain/episode");
  Inbox<EpisodeEvent> events("plain/episode_event");
  Sensor sensor("plain/wrench");
  Sequencer<std_msgs::Bool> sequencer("plain/episode_active");
  ASSERT_TRUE(sensor.WaitForSubscriber() && sequencer.WaitForSubscriber() && episodes.WaitForPublisher());
  sensor.Play(0.2, FreeAir);
  sequencer.Publish(Active(true));
  sensor.Play(0.8, Contact);
  sequencer.Publish(Active(false));
  sensor.Play(0.2, FreeAir);

  ASSERT_TRUE(episodes.WaitForCount(1));
  const Episode episode = episodes.messages().front();
  EXPECT_NEAR(episode.sample_period * static_cast<double>(episode.force.size()), 0.8, 0.1);
  EXPECT_NEAR(Greatest(episode), 20.0, 0.1);
  EXPECT_EQ(episode.end_reason, Episode::END_TRIGGER);
  EXPECT_EQ(episode.header.frame_id, "flange");
  EXPECT_TRUE(episode.complete);
  ASSERT_TRUE(events.WaitForCount(2));
  EXPECT_EQ(events.messages()[0].kind, EpisodeEvent::OPEN);
  EXPECT_EQ(events.messages()[0].header.stamp, episode.header.stamp);
  EXPECT_EQ(events.messages()[0].episode_id, episode.episode_id);
  EXPECT_EQ(events.messages()[1].kind, EpisodeEvent::CLOSE);
}

TEST(TriggerSegmentation, CutsAtTheStampsOfStampedEdges) {
  Inbox<Episode> episodes("stamped/episode");
  Sensor sensor("stamped/wrench");
  Sequencer<EpisodeEvent> sequencer("stamped/episode_event");
  ASSERT_TRUE(sensor.WaitForSubscriber() && sequencer.WaitForSubscriber() && episodes.WaitForPublisher());
  sensor.Play(0.3, FreeAir);
  EpisodeEvent event;
  event.kind = EpisodeEvent::OPEN;
  event.header.stamp = ros::Time::now() - ros::Duration(0.1);
  event.episode_id = "push 7";
  sequencer.Publish(event);
  sensor.Play(0.6, Contact);
  event.kind = EpisodeEvent::CLOSE;
  event.header.stamp += ros::Duration(0.5);
  sequencer.Publish(event);
  sensor.Play(0.2, FreeAir);

  ASSERT_TRUE(episodes.WaitForCount(1));
  const Episode episode = episodes.messages().front();
  EXPECT_EQ(episode.episode_id, "push 7");
  EXPECT_EQ(episode.header.stamp, event.header.stamp - ros::Duration(0.5));
  EXPECT_EQ(episode.force.size(), 50U);
}

TEST(TriggerSegmentation, PublishesTheOpenEpisodeAsItGrows) {
  Inbox<Episode> progress("plain/episode_progress");
  Sensor sensor("plain/wrench");
  Sequencer<std_msgs::Bool> sequencer("plain/episode_active");
  ASSERT_TRUE(sensor.WaitForSubscriber() && sequencer.WaitForSubscriber() && progress.WaitForPublisher());
  sequencer.Publish(Active(true));
  sensor.Play(0.8, Contact);
  sequencer.Publish(Active(false));
  sensor.Play(0.1, FreeAir);
  ASSERT_TRUE(progress.WaitForCount(2));
  EXPECT_FALSE(progress.messages().front().complete);
  EXPECT_LT(progress.messages().front().force.size(), progress.messages().back().force.size());
}

TEST(ContactSegmentation, OpensBeforeTheContactAndClosesAfterIt) {
  Inbox<Episode> episodes("contact/episode");
  Inbox<EpisodeEvent> events("contact/episode_event");
  Sensor sensor("contact/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber() && episodes.WaitForPublisher() && events.WaitForPublisher());
  sensor.Play(0.5, FreeAir);
  sensor.Play(1.0, Contact);

  ASSERT_TRUE(episodes.WaitForCount(1));
  const Episode episode = episodes.messages().front();
  EXPECT_EQ(episode.end_reason, Episode::END_CONTACT);
  EXPECT_NEAR(Greatest(episode), 20.0, 0.1);
  // 0.5 s before the contact, 0.3 s of contact, 0.2 s hold-off.
  EXPECT_NEAR(episode.sample_period * static_cast<double>(episode.force.size()), 1.0, 0.1);
  EXPECT_TRUE(events.WaitForCount(2));
}

TEST(ActionSegmentation, CutsWhileAGoalIsActive) {
  Inbox<Episode> episodes("action/episode");
  Sensor sensor("action/wrench");
  Sequencer<actionlib_msgs::GoalStatusArray> server("action/action_status");
  ASSERT_TRUE(sensor.WaitForSubscriber() && server.WaitForSubscriber() && episodes.WaitForPublisher());
  const auto status = [](std::uint8_t state) {
    actionlib_msgs::GoalStatusArray array;
    array.header.stamp = ros::Time::now();
    array.status_list.resize(1);
    array.status_list[0].status = state;
    return array;
  };
  sensor.Play(0.2, FreeAir);
  server.Publish(status(actionlib_msgs::GoalStatus::PENDING));
  sensor.Play(0.1, FreeAir);
  server.Publish(status(actionlib_msgs::GoalStatus::ACTIVE));
  sensor.Play(0.4, Contact);
  server.Publish(status(actionlib_msgs::GoalStatus::PREEMPTING));
  sensor.Play(0.2, FreeAir);
  server.Publish(status(actionlib_msgs::GoalStatus::PREEMPTED));
  sensor.Play(0.2, FreeAir);

  ASSERT_TRUE(episodes.WaitForCount(1));
  const Episode episode = episodes.messages().front();
  EXPECT_NEAR(episode.sample_period * static_cast<double>(episode.force.size()), 0.6, 0.1);
}

TEST(Services, StartAndStopCutAnEpisode) {
  Inbox<Episode> episodes("service/episode");
  Sensor sensor("service/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber() && episodes.WaitForPublisher());
  EXPECT_FALSE(Call("service/episode_node/stop").success) << "no episode is open";
  sensor.Play(0.2, FreeAir);
  EXPECT_TRUE(Call("service/episode_node/start").success);
  EXPECT_FALSE(Call("service/episode_node/start").success) << "an episode is open already";
  sensor.Play(0.4, Contact);
  EXPECT_TRUE(Call("service/episode_node/stop").success);
  sensor.Play(0.2, FreeAir);
  ASSERT_TRUE(episodes.WaitForCount(1));
  EXPECT_EQ(episodes.messages().front().end_reason, Episode::END_TRIGGER);
}

TEST(Services, TareReportsTheOffsetAndSubtractsIt) {
  Inbox<Episode> episodes("service/episode");
  Sensor sensor("service/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber() && episodes.WaitForPublisher());
  const auto biased = [](double /*time*/) { return 4.0; };
  sensor.Play(0.3, biased);
  const std_srvs::Trigger::Response tare = Call("service/episode_node/tare");
  EXPECT_TRUE(tare.success);
  EXPECT_NE(tare.message.find("offset [N]: 0 0 4"), std::string::npos) << tare.message;
  EXPECT_TRUE(Call("service/episode_node/start").success);
  sensor.Play(0.4, [](double time) { return 4.0 + Contact(time); });
  EXPECT_TRUE(Call("service/episode_node/stop").success);
  sensor.Play(0.2, biased);
  ASSERT_TRUE(episodes.WaitForCount(1));
  EXPECT_NEAR(episodes.messages().front().force.front(), 0.0, 0.1);
  EXPECT_NEAR(Greatest(episodes.messages().front()), 20.0, 0.1);
}

using TareService = BagTest;

TEST_F(TareService, PublishesTheOffsetForThoseWhoComeLaterAndTheReaderOfBagsUsesIt) {
  Sensor sensor("tared/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber());
  sensor.Play(0.3, [](double /*time*/) { return 4.0; });
  ASSERT_TRUE(Call("tared/episode_node/tare").success);
  Inbox<Tare> tares("tared/tare");
  ASSERT_TRUE(tares.WaitForCount(1));
  const Tare tare = tares.messages().back();
  EXPECT_NEAR(tare.force.z, 4.0, 0.01);
  EXPECT_EQ(tare.header.frame_id, "flange");
  {
    BagWriter bag(Path("tared.bag"));
    bag.Any("/tare", 0.0, tare);
    bag.Rising(0.0, 3.0);
    bag.Active(1.0, true);
    bag.Active(2.0, false);
  }
  BagReaderOptions options;
  options.segmentation.tare = core::TareSource::kService;
  const BagContents contents = ReadEpisodes(Path("tared.bag"), options);
  ASSERT_EQ(contents.episodes.size(), 1U);
  EXPECT_NEAR(contents.episodes.front().force[0], 6.05, 0.01);
}

TEST_F(TareService, KeepsTheOffsetOverARespawn) {
  const auto biased = [](double /*time*/) { return 7.0; };
  Sensor sensor("tared/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber());
  sensor.Play(0.3, biased);
  ASSERT_TRUE(Call("tared/episode_node/tare").success);
  ASSERT_TRUE(WaitForRespawn("tared/episode_node"));

  Inbox<Episode> episodes("tared/episode");
  Diagnostics diagnostics;
  ASSERT_TRUE(episodes.WaitForPublisher() && diagnostics.WaitFor("tared/episode_node", [&](const auto& status) {
    sensor.Play(0.05, biased);
    return std::any_of(status.values.begin(), status.values.end(),
                       [](const auto& entry) { return entry.key == "samples" && entry.value != "0"; });
  }));
  EXPECT_TRUE(Call("tared/episode_node/start").success);
  sensor.Play(0.4, [](double time) { return 7.0 + Contact(time); });
  EXPECT_TRUE(Call("tared/episode_node/stop").success);
  sensor.Play(0.2, biased);
  ASSERT_TRUE(episodes.WaitForCount(1));
  EXPECT_NEAR(episodes.messages().front().force.front(), 0.0, 0.1);
  Inbox<Tare> tares("tared/tare");
  ASSERT_TRUE(tares.WaitForCount(1)) << "a recording that starts now needs it";
  EXPECT_GT(tares.messages().front().header.stamp, ros::Time(1.0)) << "when it was measured";
}

TEST_F(TareService, IgnoresTheOffsetOfAnotherLaunch) {
  Diagnostics diagnostics;
  Sensor sensor("stale/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber());
  EXPECT_TRUE(diagnostics.WaitFor("stale/episode_node", [&](const DiagnosticStatus& status) {
    sensor.Play(0.05, FreeAir);
    return std::any_of(status.values.begin(), status.values.end(),
                       [](const auto& entry) { return entry.value == "not tared"; });
  }));
}

TEST(TwoPublishers, OnTheWrenchTopicAreNamed) {
  Diagnostics diagnostics;
  Sensor driver("doubled/driver_message");
  Sensor other("doubled/wrench");
  ASSERT_TRUE(driver.WaitForSubscriber() && other.WaitForSubscriber());
  double force = 0.0;
  EXPECT_TRUE(WaitUntil([&] {
    force = 1.0 - force;
    driver.Publish(WrenchOf(ros::Time::now(), force));
    other.Publish(WrenchOf(ros::Time::now(), force + 2.0));
    return diagnostics.Says("doubled/episode_node", DiagnosticStatus::ERROR, "two publishers on one topic");
  }));
}

TEST(BadWrench, IsDroppedAndCounted) {
  Inbox<Episode> episodes("bad/episode");
  Diagnostics diagnostics;
  Sensor sensor("bad/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber() && episodes.WaitForPublisher());
  sensor.Play(0.2, FreeAir);
  EXPECT_TRUE(Call("bad/episode_node/start").success);
  sensor.Play(0.2, FreeAir);
  sensor.Publish(WrenchOf(ros::Time::now(), std::numeric_limits<double>::quiet_NaN()));
  sensor.Publish(WrenchOf(ros::Time::now(), std::numeric_limits<double>::infinity()));
  sensor.Play(0.2, Contact);
  EXPECT_TRUE(Call("bad/episode_node/stop").success);
  sensor.Play(0.2, FreeAir);
  ASSERT_TRUE(episodes.WaitForCount(1));
  for (const float force : episodes.messages().front().force) EXPECT_TRUE(std::isfinite(force));
  EXPECT_TRUE(diagnostics.WaitForValue("bad/episode_node", "not finite", "2"));
}

TEST(BadWrench, ThatHasAnotherNameIsReportedWithTheTopicsOfItsType) {
  Diagnostics diagnostics;
  Sensor sensor("deaf/ft_sensor");
  EXPECT_TRUE(diagnostics.WaitFor("deaf/episode_node", [](const DiagnosticStatus& status) {
    return status.level == DiagnosticStatus::WARN && status.message.find("/deaf/wrench") != std::string::npos &&
           status.message.find("/deaf/ft_sensor") != std::string::npos;
  }));
}

TEST(BadWrench, ThatStopsIsReported) {
  Diagnostics diagnostics;
  Sensor sensor("bad/wrench");
  ASSERT_TRUE(sensor.WaitForSubscriber());
  sensor.Play(0.2, FreeAir);
  EXPECT_TRUE(diagnostics.WaitFor("bad/episode_node", DiagnosticStatus::ERROR, "no wrench for"));
}

TEST(BadParameters, OfTheEpisodeNodeAreNamedAndTheNodeStaysUp) {
  Diagnostics diagnostics;
  EXPECT_TRUE(diagnostics.WaitFor("faulty/episode_node", [](const DiagnosticStatus& status) {
    return status.level == DiagnosticStatus::ERROR && status.message.find("max_duration") != std::string::npos &&
           status.message.find("contact_on") != std::string::npos;
  }));
  const std_srvs::Trigger::Response response = Call("faulty/episode_node/start");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("max_duration"), std::string::npos) << response.message;
}

}  // namespace
}  // namespace contact_shapelets::test
