#pragma once

#include <rosbag/bag.h>

#include <map>
#include <string>
#include <vector>

/// \file
/// Which topics a bag holds, and which of them play which part.

namespace contact_shapelets {

/// Opens a bag for reading. \throws std::runtime_error in one line that names the file, what was `expected` and what is
/// wrong with it.
void OpenBag(const std::string& path, rosbag::Bag* bag, const std::string& expected = "a bag");

/// Topics of a bag by the type of their messages.
class BagTopics {
 public:
  /// Lists the topics of `bag`.
  explicit BagTopics(const rosbag::Bag& bag);

  /// All topics with messages of `type`, such as "geometry_msgs/WrenchStamped", in alphabetical order.
  std::vector<std::string> OfType(const std::string& type) const;
  /// The topics of `type` whose last part is `name` ("/robot/episode_active" for "episode_active").
  std::vector<std::string> Named(const std::string& name, const std::string& type) const;
  /// "none" or the topics with their types, in one line.
  std::string List() const;

 private:
  std::map<std::string, std::string> type_of_;
};

/// `names` with commas between them.
std::string Joined(const std::vector<std::string>& names);

/// The topic of the wrench among `topics` of the bag `path`: `wanted`, or the only one of type WrenchStamped if
/// `wanted` is empty. \throws std::runtime_error in one line that names the bag if there is none, or more than one.
std::string WrenchTopicOf(const std::string& path, const BagTopics& topics, const std::string& wanted);

}  // namespace contact_shapelets
