#pragma once

#include <rosbag/bag.h>

#include <map>
#include <string>
#include <vector>

/// \file
/// The topics of a bag.

namespace contact_shapelets {

/// Opens a bag for reading. \throws std::runtime_error in one line that names the file, what was `expected` and what is
/// wrong with it.
void OpenBag(const std::string& path, rosbag::Bag* bag, const std::string& expected = "a bag");

/// The topics of a bag with the types of their messages.
class BagTopics {
 public:
  /// Lists the topics of `bag`.
  explicit BagTopics(const rosbag::Bag& bag);

  /// Returns all topics with messages of `type`, such as "geometry_msgs/WrenchStamped", in alphabetical order.
  std::vector<std::string> OfType(const std::string& type) const;
  /// Returns the topics of `type` that end in `name` ("/robot/episode_active" for "episode_active").
  std::vector<std::string> Named(const std::string& name, const std::string& type) const;
  /// Returns true if the bag has this topic.
  bool Has(const std::string& topic) const { return type_of_.count(topic) > 0; }
  /// Returns the topics with their types in one line, or "none".
  std::string List() const;

 private:
  std::map<std::string, std::string> type_of_;
};

/// `names` with commas between them.
std::string Joined(const std::vector<std::string>& names);

/// The topic of the wrench among `topics` of the bag `path`: `wanted`, of any type, or the only one of type
/// WrenchStamped if `wanted` is empty. \throws std::runtime_error in one line that names the bag if there is none, or
/// more than one.
std::string WrenchTopicOf(const std::string& path, const BagTopics& topics, const std::string& wanted);

}  // namespace contact_shapelets
