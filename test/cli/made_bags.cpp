#include "cli/made_bags.h"

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <topic_tools/shape_shifter.h>

#include <array>
#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "contact_shapelets/Episode.h"

namespace contact_shapelets::test {
namespace {

constexpr int kRate = 100;
constexpr int kCycle = 300;
constexpr double kStart = 10000.0;
constexpr std::array<const char*, 3> kOutcomes{"sharp", "broad", "double"};

/// Returns the push force at `time` [s] of its cycle: a short pulse, a long one, or two.
double Pulse(int kind, double time) {
  const auto bell = [time](double middle, double width) {
    return 15.0 * std::exp(-std::pow((time - middle) / width, 2));
  };
  if (kind == 0) return bell(1.0, 0.08);
  if (kind == 1) return bell(1.2, 0.5);
  return bell(0.9, 0.1) + bell(1.5, 0.1);
}

/// Changes the message of this sample to that of a flawed driver. Returns false if the driver would not send it.
bool Spoil(Flaw flaw, int sample, geometry_msgs::WrenchStamped* wrench) {
  if (flaw == Flaw::kNotFinite && sample % 50 == 7) wrench->wrench.force.y = std::numeric_limits<double>::quiet_NaN();
  if (flaw == Flaw::kFlat) wrench->wrench.force.x = 2.0;
  if (flaw == Flaw::kZeroStamps) wrench->header.stamp = ros::Time();
  if (flaw == Flaw::kLateStamps) wrench->header.stamp -= ros::Duration(3600.0);
  return flaw != Flaw::kGap || sample % kCycle < 100 || sample % kCycle >= 150;
}

/// Writes the wrench of one topic.
class WrenchWriter {
 public:
  WrenchWriter(const std::string& topic, Flaw flaw, rosbag::Bag* bag) : topic_(topic), flaw_(flaw), bag_(bag) {}

  void Write(int sample, double force) {
    const ros::Time arrival(kStart + static_cast<double>(sample) / kRate);
    geometry_msgs::WrenchStamped wrench;
    wrench.header.stamp = arrival;
    wrench.header.frame_id = "flange";
    wrench.wrench.force.x = force;
    const bool sent = Spoil(flaw_, sample, &wrench);
    const bool again = sample > 0 && (flaw_ == Flaw::kFrozen || (flaw_ == Flaw::kRepeated && sample % 10 == 0));
    if (!again) last_ = wrench;
    if (sent) bag_->write(topic_, arrival, last_, ConnectionOf(sample));
  }

 private:
  /// A driver's connection has a header of its own; without one all messages have the same.
  boost::shared_ptr<ros::M_string> ConnectionOf(int sample) const {
    if (flaw_ != Flaw::kPublishers) return {};
    const geometry_msgs::WrenchStamped wrench;
    return boost::make_shared<ros::M_string>(ros::M_string{
        {"topic", topic_},
        {"callerid", sample % 2 == 0 ? "/driver" : "/other_driver"},
        {"type", ros::message_traits::datatype(wrench)},
        {"md5sum", ros::message_traits::md5sum(wrench)},
        {"message_definition", ros::message_traits::definition(wrench)},
    });
  }

  std::string topic_;
  Flaw flaw_;
  rosbag::Bag* bag_;
  geometry_msgs::WrenchStamped last_;
};

void WriteTrigger(double time, bool active, rosbag::Bag* bag) {
  std_msgs::Bool message;
  message.data = active ? 1U : 0U;
  bag->write("/episode_active", ros::Time(time), message);
}

}  // namespace

std::string Make(const std::string& path, const MadeBag& content) {
  std::mt19937 generator(1);
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  std::vector<WrenchWriter> writers;
  for (const std::string& topic : content.wrench_topics) writers.emplace_back(topic, content.flaw, &bag);
  const int samples = content.episodes * kCycle - (content.cut_off ? kCycle / 2 : 0);
  for (int sample = 0; sample < samples; ++sample) {
    // The distributions of standard libraries differ, so the noise is computed here.
    const double noise = 0.4 * (static_cast<double>(generator()) / 4294967296.0 - 0.5);
    const double force = Pulse(sample / kCycle % 3, static_cast<double>(sample % kCycle) / kRate) + noise;
    for (WrenchWriter& writer : writers) writer.Write(sample, force);
  }
  for (int episode = 0; episode < content.episodes; ++episode) {
    const double begin = kStart + 3.0 * episode + 0.1;
    if (content.triggers) WriteTrigger(begin, true, &bag);
    if (content.cut_off && episode + 1 == content.episodes) break;
    if (content.triggers) WriteTrigger(begin + 2.4, false, &bag);
    std_msgs::String outcome;
    outcome.data = kOutcomes[static_cast<std::size_t>(episode % 3)];
    if (content.outcomes) bag.write("/outcome", ros::Time(begin + 2.6), outcome);
  }
  bag.close();
  return path;
}

std::string Merge(const std::vector<std::string>& bags, const std::string& path) {
  rosbag::Bag output(path, rosbag::bagmode::Write);
  for (const std::string& bag : bags) {
    const rosbag::Bag input(bag, rosbag::bagmode::Read);
    rosbag::View view(input);
    for (const rosbag::MessageInstance& message : view) output.write(message.getTopic(), message.getTime(), message);
  }
  output.close();
  return path;
}

std::string CutEpisodes(const std::string& source, int count, const std::string& path) {
  const rosbag::Bag input(source, rosbag::bagmode::Read);
  rosbag::Bag output(path, rosbag::bagmode::Write);
  rosbag::View view(input, rosbag::TypeQuery("contact_shapelets/Episode"));
  for (const rosbag::MessageInstance& message : view) {
    if (count-- > 0) output.write(message.getTopic(), message.getTime(), message);
  }
  output.close();
  return path;
}

std::string MakeModelOfAnotherVersion(const std::string& path) {
  topic_tools::ShapeShifter message;
  message.morph("0123456789abcdef0123456789abcdef", "contact_shapelets/ShapeletModel", "uint8 nothing\n", "");
  std::array<std::uint8_t, 1> content{};
  ros::serialization::IStream stream(content.data(), content.size());
  message.read(stream);
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.write("model", ros::Time(kStart), message);
  bag.close();
  return path;
}

}  // namespace contact_shapelets::test
