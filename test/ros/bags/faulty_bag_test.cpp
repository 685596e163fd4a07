// Messages of the bag reader about bags that it cannot use: one line with the file, what it expected and what it found.
#include <geometry_msgs/PointStamped.h>
#include <topic_tools/shape_shifter.h>

#include <limits>

#include "contact_shapelets/ros/episode_bag_reader.h"
#include "ros/bags/bag_fixture.h"

namespace contact_shapelets {
namespace {

class FaultyBagTest : public BagTest {
 protected:
  std::string MessageFor(const std::string& name, const BagReaderOptions& options = BagReaderOptions()) const {
    return MessageOf([&] { ReadEpisodes(Path(name), options); });
  }
};

TEST_F(FaultyBagTest, NoSuchFile) {
  ExpectWords(MessageFor("none.bag"), {Path("none.bag"), "expected a bag", "no such file"});
}

TEST_F(FaultyBagTest, AFolder) {
  std::filesystem::create_directory(folder_ / "folder.bag");
  ExpectWords(MessageFor("folder.bag"), {Path("folder.bag"), "expected a bag", "not a file"});
}

TEST_F(FaultyBagTest, AnEmptyFile) {
  Write(Path("empty.bag"), "");
  ExpectWords(MessageFor("empty.bag"), {Path("empty.bag"), "expected a bag", "empty"});
}

TEST_F(FaultyBagTest, NotABag) {
  Write(Path("text.bag"), "time,fx,fy,fz\n0.0,1.0,2.0,3.0\n");
  ExpectWords(MessageFor("text.bag"), {Path("text.bag"), "expected a bag", "cannot be read"});
}

TEST_F(FaultyBagTest, ABagThatWasCutOffAnywhere) {
  {
    BagWriter bag(Path("whole.bag"));
    bag.Rising(0.0, 0.5);
    bag.Active(0.1, true);
    bag.Active(0.4, false);
  }
  const std::string whole = Contents(Path("whole.bag"));
  for (std::size_t length = 1; length < whole.size(); length += 501) {
    Write(Path("cut.bag"), whole.substr(0, length));
    ExpectWords(MessageFor("cut.bag"), {Path("cut.bag"), "expected a bag"});
  }
}

TEST_F(FaultyBagTest, ABagThatWasStillBeingRecorded) {
  BagWriter(Path("killed.bag")).Rising(0.0, 0.5);
  // If a recorder is killed, the position of the index in the header stays zero.
  std::string contents = Contents(Path("killed.bag"));
  const std::string field = "index_pos=";
  contents.replace(contents.find(field) + field.size(), 8, 8, '\0');
  Write(Path("killed.bag"), contents);
  ExpectWords(MessageFor("killed.bag"), {Path("killed.bag"), "rosbag reindex"});
}

TEST_F(FaultyBagTest, ABagWithoutAMessage) {
  { const BagWriter bag(Path("bare.bag")); }
  ExpectWords(MessageFor("bare.bag"), {Path("bare.bag"), "geometry_msgs/WrenchStamped", "found none"});
}

TEST_F(FaultyBagTest, NoWrenchTopic) {
  BagWriter(Path("other.bag")).Any("/point", 0.0, geometry_msgs::PointStamped());
  ExpectWords(MessageFor("other.bag"),
              {Path("other.bag"), "geometry_msgs/WrenchStamped", "/point (geometry_msgs/PointStamped)"});
}

TEST_F(FaultyBagTest, TwoWrenchTopics) {
  {
    BagWriter bag(Path("two.bag"));
    bag.Wrench(0.0, 1.0, "/left/wrench");
    bag.Wrench(0.0, 1.0, "/right/wrench");
  }
  ExpectWords(MessageFor("two.bag"), {Path("two.bag"), "/left/wrench, /right/wrench", "--wrench-topic"});
}

TEST_F(FaultyBagTest, AChosenWrenchTopicThatIsNotThere) {
  BagWriter(Path("wrench.bag")).Wrench(0.0, 1.0);
  BagReaderOptions options;
  options.wrench_topic = "/ft_sensor";
  ExpectWords(MessageFor("wrench.bag", options), {Path("wrench.bag"), "/ft_sensor", "/wrench"});
}

TEST_F(FaultyBagTest, TwoTriggers) {
  {
    BagWriter bag(Path("two.bag"));
    bag.Wrench(0.0, 1.0);
    bag.Active(0.0, true, "/left/episode_active");
    bag.Active(0.0, true, "/right/episode_active");
  }
  ExpectWords(MessageFor("two.bag"), {Path("two.bag"), "/left/episode_active, /right/episode_active"});
}

TEST_F(FaultyBagTest, NoTrigger) {
  BagWriter(Path("raw.bag")).Rising(0.0, 1.0);
  ExpectWords(MessageFor("raw.bag"),
              {Path("raw.bag"), "at least one episode", "episode_active", "segmentation: contact"});
}

TEST_F(FaultyBagTest, TriggersThatOpenNothing) {
  {
    BagWriter bag(Path("raw.bag"));
    bag.Rising(0.0, 1.0);
    bag.Active(0.5, false);
  }
  ExpectWords(MessageFor("raw.bag"), {Path("raw.bag"), "at least one episode", "triggers"});
}

TEST_F(FaultyBagTest, NoContactAndNoAction) {
  BagWriter(Path("raw.bag")).Wrench(0.0, 1.0);
  BagReaderOptions options;
  options.segmentation.segmentation = core::SegmentationMode::kContact;
  ExpectWords(MessageFor("raw.bag", options), {Path("raw.bag"), "at least one episode", "contact_on", "/wrench"});
  options.segmentation.segmentation = core::SegmentationMode::kAction;
  ExpectWords(MessageFor("raw.bag", options),
              {Path("raw.bag"), "at least one episode", "actionlib_msgs/GoalStatusArray"});
}

TEST_F(FaultyBagTest, EpisodesThatHoldNoSeries) {
  Episode message;
  message.sample_period = 0.01;
  BagWriter(Path("episodes.bag")).Any("/episode", 0.0, message);
  ExpectWords(MessageFor("episodes.bag"), {Path("episodes.bag"), "at least one episode", "/episode"});
}

TEST_F(FaultyBagTest, EpisodesWithValuesThatNoSensorGives) {
  Episode message;
  message.episode_id = "push_3";
  message.sample_period = 0.01;
  message.force.assign(20, 1.0F);
  message.force[7] = std::numeric_limits<float>::quiet_NaN();
  BagWriter(Path("episodes.bag")).Any("/episode", 0.0, message);
  ExpectWords(MessageFor("episodes.bag"), {Path("episodes.bag"), "push_3", "not finite"});
  message.force[7] = 1e19F;
  BagWriter(Path("episodes.bag")).Any("/episode", 0.0, message);
  ExpectWords(MessageFor("episodes.bag"), {Path("episodes.bag"), "push_3", "above 2e6 N"});
  message.force[7] = 1.0F;
  message.sample_period = 0.0;
  BagWriter(Path("episodes.bag")).Any("/episode", 0.0, message);
  ExpectWords(MessageFor("episodes.bag"), {Path("episodes.bag"), "push_3", "sample period"});
}

TEST_F(FaultyBagTest, EpisodesOfAnotherVersion) {
  const std::string other = "0123456789abcdef0123456789abcdef";
  topic_tools::ShapeShifter shape;
  shape.morph(other, "contact_shapelets/Episode", "uint32 version\n", "");
  BagWriter(Path("episodes.bag")).Any("/episode", 0.0, shape);
  ExpectWords(MessageFor("episodes.bag"), {Path("episodes.bag"), "/episode", "another version", other});
}

TEST_F(FaultyBagTest, NoBagAtAll) {
  ExpectWords(MessageOf([] { ReadAllEpisodes({}, BagReaderOptions()); }), {"expected at least one bag"});
}

}  // namespace
}  // namespace contact_shapelets
