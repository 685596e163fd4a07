#include "ros/bags/wrench_recording.h"

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <stdexcept>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "core/stream/resampler.h"
#include "ros/bags/bag_damage.h"
#include "ros/bags/bag_topics.h"
#include "ros/bags/wrench_messages.h"
#include "ros/messages/conversions.h"

namespace contact_shapelets {
namespace {

constexpr double kMostPeriods = 1e8;

std::vector<core::WrenchSample> ReadSamples(const rosbag::Bag& bag, const std::string& topic,
                                            const WrenchSource& source) {
  std::vector<core::WrenchSample> samples;
  WrenchMessages wrenches(topic, source);
  std::vector<std::string> topics{topic};
  if (!wrenches.joint_states().empty()) topics.push_back(wrenches.joint_states());
  rosbag::View view(bag, rosbag::TopicQuery(topics));
  for (const rosbag::MessageInstance& message : view) {
    const auto wrench = wrenches.Read(message);
    if (!wrench) continue;
    core::WrenchSample sample;
    const core::Nanoseconds stamp = ToNanoseconds(wrench->header.stamp);
    sample.time = stamp > 0 ? stamp : ToNanoseconds(message.getTime());
    sample.force = ToVector(wrench->wrench.force);
    const bool later = samples.empty() || sample.time > samples.back().time;
    if (later && sample.force.norm() <= core::kGreatestForce) samples.push_back(sample);
  }
  if (samples.empty() && !wrenches.fault().empty()) throw std::runtime_error(wrenches.fault());
  return samples;
}

}  // namespace

WrenchRecording ReadWrenchRecording(const std::string& path, const std::string& wrench_topic, double sample_period,
                                    const WrenchSource& source) {
  BagDamage damage(path);
  rosbag::Bag bag;
  OpenBag(path, &bag);
  WrenchRecording recording;
  recording.topic = WrenchTopicOf(path, BagTopics(bag), wrench_topic);
  std::vector<core::WrenchSample> samples;
  try {
    samples = ReadSamples(bag, recording.topic, source);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": expected a whole bag, but it is damaged: " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (samples.size() < 2) {
    throw std::runtime_error(path + ": expected at least 2 usable samples on " + recording.topic + ", but found " +
                             std::to_string(samples.size()));
  }
  const core::Nanoseconds end = samples.back().time;
  recording.begin = samples.front().time;
  recording.sample_period = sample_period;
  if (core::ToSeconds(end - recording.begin) / sample_period > kMostPeriods) {
    throw std::runtime_error(path + ": its stamps on " + recording.topic + " span " +
                             std::to_string(core::ToSeconds(end - recording.begin)) +
                             " s, too long for a sample_period of " + std::to_string(sample_period) + " s");
  }
  recording.force = core::ResampledMagnitude(samples, recording.begin, end, sample_period, Eigen::Vector3d::Zero());
  return recording;
}

}  // namespace contact_shapelets
