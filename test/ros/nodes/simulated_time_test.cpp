/// Simulated time jumps back, as in a bag that plays in a loop.

#include <contact_shapelets/Episode.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>

#include "ros/nodes/live_helpers.h"

namespace contact_shapelets::test {
namespace {

/// Clock, sensor and sequencer of the node under test.
class SimulatedTime : public testing::Test {
 protected:
  SimulatedTime()
      : clock_(node_handle_.advertise<rosgraph_msgs::Clock>("/clock", 10)),
        sequencer_(node_handle_.advertise<EpisodeEvent>("episode_event", 10)),
        sensor_("wrench"),
        episodes_("episode"),
        health_("/diagnostics") {}

  void SetUp() override {
    ASSERT_TRUE(sensor_.WaitForSubscriber() && episodes_.WaitForPublisher() && health_.WaitForPublisher());
    ASSERT_TRUE(WaitUntil([this] { return clock_.getNumSubscribers() > 1 && sequencer_.getNumSubscribers() > 0; }));
  }

  /// Sets the clock and waits until the node has the new time.
  bool SetClock(double time) {
    rosgraph_msgs::Clock message;
    message.clock = ros::Time(time);
    clock_.publish(message);
    health_.Clear();
    return WaitUntil([&] {
      return std::any_of(health_.messages().begin(), health_.messages().end(),
                         [&](const auto& array) { return array.header.stamp == ros::Time(time); });
    });
  }
  /// Publishes wrenches at 200 Hz of simulated time from `begin` to `end`, and waits until the node has them. Otherwise
  /// they could arrive after the next jump of the clock on a busy machine. Call SetClock() after each jump first,
  /// because this needs the node's diagnostics since then.
  void PlayWrench(double begin, double end) {
    const int before = Samples();
    int count = 0;
    for (; begin + 0.005 * count <= end; ++count) {
      sensor_.Publish(WrenchOf(ros::Time(begin + 0.005 * count), count % 2 == 0 ? 0.001 : 0.002));
    }
    ASSERT_TRUE(WaitUntil([&] { return Samples() == before + count; }));
  }
  /// Returns the number of samples that the node has taken, by its last diagnostics.
  int Samples() const {
    for (const auto& value : health_.messages().back().status.front().values) {
      if (value.key == "samples") return std::stoi(value.value);
    }
    return -1;
  }
  void Edge(std::uint8_t kind, double time, const std::string& id) {
    EpisodeEvent event;
    event.header.stamp = ros::Time(time);
    event.kind = kind;
    event.episode_id = id;
    sequencer_.publish(event);
  }

  ros::NodeHandle node_handle_;
  ros::Publisher clock_;
  ros::Publisher sequencer_;
  Sensor sensor_;
  Inbox<Episode> episodes_;
  Inbox<diagnostic_msgs::DiagnosticArray> health_;
};

TEST_F(SimulatedTime, ThatJumpsBackEndsTheOpenEpisodeAndStartsAnew) {
  ASSERT_TRUE(SetClock(100.0));
  PlayWrench(99.5, 100.0);
  Edge(EpisodeEvent::OPEN, 100.0, "cut off");
  ASSERT_TRUE(SetClock(100.5));
  PlayWrench(100.005, 100.5);

  ASSERT_TRUE(SetClock(50.0));
  PlayWrench(49.5, 50.0);
  ASSERT_TRUE(episodes_.WaitForCount(1));
  EXPECT_EQ(episodes_.messages().back().episode_id, "cut off");
  EXPECT_EQ(episodes_.messages().back().end_reason, Episode::END_STREAM);
  EXPECT_FALSE(episodes_.messages().back().complete);
  EXPECT_EQ(episodes_.messages().back().force.size(), 50U);

  Edge(EpisodeEvent::OPEN, 50.0, "whole");
  ASSERT_TRUE(SetClock(50.4));
  PlayWrench(50.005, 50.4);
  Edge(EpisodeEvent::CLOSE, 50.3, "whole");
  ASSERT_TRUE(episodes_.WaitForCount(2));
  EXPECT_EQ(episodes_.messages().back().episode_id, "whole");
  EXPECT_EQ(episodes_.messages().back().force.size(), 30U);
  EXPECT_TRUE(episodes_.messages().back().complete);
}

TEST_F(SimulatedTime, AnEdgeThatIsFasterThanTheFirstWrenchAfterAJumpIsKept) {
  ASSERT_TRUE(SetClock(200.0));
  PlayWrench(199.5, 200.0);
  ASSERT_TRUE(SetClock(20.0));
  Edge(EpisodeEvent::OPEN, 20.0, "early");
  ASSERT_TRUE(SetClock(20.4));
  PlayWrench(20.0, 20.4);
  Edge(EpisodeEvent::CLOSE, 20.3, "early");
  ASSERT_TRUE(episodes_.WaitForCount(1));
  EXPECT_EQ(episodes_.messages().back().episode_id, "early");
  EXPECT_EQ(episodes_.messages().back().force.size(), 30U);
}

}  // namespace
}  // namespace contact_shapelets::test
