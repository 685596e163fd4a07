#include "ros/bags/bag_topics.h"

#include <rosbag/view.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace contact_shapelets {
namespace {

constexpr char kWrenchType[] = "geometry_msgs/WrenchStamped";

}  // namespace

void OpenBag(const std::string& path, rosbag::Bag* bag, const std::string& expected) {
  const std::string but = path + ": expected " + expected + ", but ";
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    throw std::runtime_error(but + (missing ? "there is no such file" : std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) throw std::runtime_error(but + "it is not a file");
  if (status.st_size == 0) throw std::runtime_error(but + "the file is empty");
  if (access(path.c_str(), R_OK) != 0) throw std::runtime_error(but + "it cannot be read: " + std::strerror(errno));
  std::string start(9, '\0');
  std::ifstream(path).read(&start[0], static_cast<std::streamsize>(start.size()));
  if (start != "#ROSBAG V") throw std::runtime_error(but + "it cannot be read: the file is of another kind");
  try {
    bag->open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(but + "it has no index, because its recording was cut off: run `rosbag reindex` on it");
  } catch (const std::exception& error) {
    throw std::runtime_error(but + "it is cut off or damaged; `rosbag reindex` may save a part: " + error.what());
  }
}

BagTopics::BagTopics(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    type_of_[connection->topic] = connection->datatype;
  }
}

std::vector<std::string> BagTopics::OfType(const std::string& type) const {
  std::vector<std::string> topics;
  for (const auto& [topic, topic_type] : type_of_) {
    if (topic_type == type) topics.push_back(topic);
  }
  return topics;
}

std::vector<std::string> BagTopics::Named(const std::string& name, const std::string& type) const {
  std::vector<std::string> topics = OfType(type);
  const auto other = [&name](const std::string& topic) { return topic.substr(topic.rfind('/') + 1) != name; };
  topics.erase(std::remove_if(topics.begin(), topics.end(), other), topics.end());
  return topics;
}

std::string BagTopics::List() const {
  if (type_of_.empty()) return "none";
  std::ostringstream list;
  const char* separator = "";
  for (const auto& [topic, type] : type_of_) {
    list << separator << topic << " (" << type << ')';
    separator = ", ";
  }
  return list.str();
}

std::string Joined(const std::vector<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

std::string WrenchTopicOf(const std::string& path, const BagTopics& topics, const std::string& wanted) {
  const std::vector<std::string> wrenches = topics.OfType(kWrenchType);
  if (!wanted.empty()) {
    for (const std::string& topic : {wanted, "/" + wanted}) {
      if (topics.Has(topic)) return topic;
    }
    throw std::runtime_error(path + ": expected a wrench on " + wanted + ", but found " + topics.List());
  }
  if (wrenches.empty()) {
    throw std::runtime_error(path + ": expected a topic of type " + kWrenchType +
                             " or contact_shapelets/Episode, but found " + topics.List());
  }
  if (wrenches.size() > 1) {
    throw std::runtime_error(path + ": expected one topic of type " + std::string(kWrenchType) + ", but found " +
                             Joined(wrenches) + "; choose one by --wrench-topic");
  }
  return wrenches.front();
}

}  // namespace contact_shapelets
