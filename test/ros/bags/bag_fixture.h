#pragma once

#include <contact_shapelets/Episode.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>

namespace contact_shapelets {

/// Gives each test a folder, and removes it afterwards.
class BagTest : public testing::Test {
 protected:
  BagTest() {
    std::string name = (std::filesystem::temp_directory_path() / "contact_shapelets_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder at " + name);
    folder_ = name;
  }
  ~BagTest() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  static std::string Contents(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  static void Write(const std::string& path, const std::string& contents) {
    std::ofstream(path, std::ios::binary) << contents;
  }

  std::filesystem::path folder_;
};

/// Returns the message of the exception that `action` throws; an empty string if it throws none.
template <typename Action>
std::string MessageOf(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

inline void ExpectWords(const std::string& message, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << "\nin: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

inline ros::Time At(double seconds) { return ros::Time(1000.0 + seconds); }

/// Writes a bag of one sensor and its triggers. Times are in seconds after a fixed date.
class BagWriter {
 public:
  explicit BagWriter(const std::string& path) : bag_(path, rosbag::bagmode::Write) {}

  void Wrench(double time, double force, const std::string& topic = "/wrench") {
    geometry_msgs::WrenchStamped message;
    message.header.stamp = At(time);
    message.header.frame_id = "flange";
    message.wrench.force.z = force;
    // A message takes 2 ms from the driver to the recorder.
    bag_.write(topic, At(time + 0.002), message);
  }
  /// A force that rises by 10 N/s, at 100 Hz.
  void Rising(double begin, double end, const std::string& topic = "/wrench") {
    for (int index = 0; index < std::lround(100.0 * (end - begin)); ++index) {
      const double time = begin + 0.01 * index;
      Wrench(time, 10.0 * time, topic);
    }
  }
  void Active(double time, bool active, const std::string& topic = "/episode_active") {
    std_msgs::Bool message;
    message.data = static_cast<std_msgs::Bool::_data_type>(active);
    // As long as the wrench: what one message takes, another takes.
    bag_.write(topic, At(time + 0.002), message);
  }
  void Event(double arrival, double stamp, bool open, const std::string& id = "") {
    EpisodeEvent message;
    message.header.stamp = At(stamp);
    message.kind = open ? EpisodeEvent::OPEN : EpisodeEvent::CLOSE;
    message.episode_id = id;
    bag_.write("/episode_event", At(arrival), message);
  }
  void Outcome(double time, const std::string& outcome) {
    std_msgs::String message;
    message.data = outcome;
    bag_.write("/outcome", At(time), message);
  }
  /// Writes any message.
  template <typename Message>
  void Any(const std::string& topic, double time, const Message& message) {
    bag_.write(topic, At(time), message);
  }

 private:
  rosbag::Bag bag_;
};

}  // namespace contact_shapelets
