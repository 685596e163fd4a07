#include "cli/bag_inspection.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/view.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "cli/text.h"
#include "contact_shapelets/core/wrench_stream.h"
#include "contact_shapelets/ros/model_bag.h"
#include "ros/bags/bag_damage.h"
#include "ros/bags/bag_topics.h"
#include "ros/bags/wrench_messages.h"
#include "ros/messages/action_edges.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publisher_watch.h"

namespace contact_shapelets::cli {
namespace {

/// Wrenches for each sample period below which the rate is slow: a little less than 30 Hz for 0.01 s.
constexpr double kSlow = 0.28;
constexpr char kWrenchType[] = "geometry_msgs/WrenchStamped";
constexpr char kEpisodeType[] = "contact_shapelets/Episode";
constexpr char kModelType[] = "contact_shapelets/ShapeletModel";
constexpr char kStatusType[] = "actionlib_msgs/GoalStatusArray";

bool IsNamed(const std::string& topic, const char* name) { return FileName(topic) == name; }

/// Returns true if messages of this topic mark, name or hold episodes.
bool IsMarker(const std::string& topic, const std::string& type) {
  return type == "contact_shapelets/EpisodeEvent" || type == kEpisodeType || type == kStatusType ||
         type == kModelType || (type == "std_msgs/Bool" && IsNamed(topic, topics::kEpisodeActive)) ||
         (type == "std_msgs/String" && IsNamed(topic, topics::kOutcome));
}

/// Follows one wrench topic.
class WrenchFollower {
 public:
  WrenchFollower(const std::string& topic, const std::string& type, const BagReaderOptions& options)
      : type_(type), wrenches_(topic, options.source), stream_(options.segmentation) {}

  void Take(const rosbag::MessageInstance& message) {
    if (!wrenches_.Reads(message.getTopic())) return;
    const auto wrench = wrenches_.Read(message);
    if (!wrench) return;
    if (const auto publisher = publisher_.Next(message.getConnectionHeader())) stream_.SetPublisher(*publisher);
    const core::Nanoseconds arrival = ToNanoseconds(message.getTime());
    if (messages_++ == 0) first_arrival_ = arrival;
    last_arrival_ = arrival;
    frames_.insert(wrench->header.frame_id);
    stream_.AddWrench(ToNanoseconds(wrench->header.stamp), arrival, ToVector(wrench->wrench.force));
    stream_.TakeEpisodes();
    stream_.TakeEdges();
  }

  WrenchTopic Result(const std::string& name) const {
    WrenchTopic topic;
    topic.name = name;
    topic.type = type_;
    topic.frames.assign(frames_.begin(), frames_.end());
    topic.messages = messages_;
    topic.received_duration = core::ToSeconds(last_arrival_ - first_arrival_);
    topic.stream = stream_.Summary();
    return topic;
  }

 private:
  std::string type_;
  WrenchMessages wrenches_;
  core::WrenchStream stream_;
  PublisherWatch publisher_;
  std::set<std::string> frames_;
  int messages_ = 0;
  core::Nanoseconds first_arrival_ = 0;
  core::Nanoseconds last_arrival_ = 0;
};

/// Counts what the messages of a marker topic say.
class MarkerFollower {
 public:
  void Take(const rosbag::MessageInstance& message) {
    if (const auto active = message.instantiate<std_msgs::Bool>()) ++counts_[active->data != 0U ? "true" : "false"];
    if (const auto outcome = message.instantiate<std_msgs::String>()) ++counts_[outcome->data];
    if (const auto event = message.instantiate<EpisodeEvent>()) {
      ++counts_[event->kind == EpisodeEvent::OPEN ? "open" : "close"];
    }
    if (const auto status = message.instantiate<actionlib_msgs::GoalStatusArray>()) {
      ++counts_[AnyGoalActive(*status) ? "with an active goal" : "without"];
    }
  }
  std::string Contents() const { return CountsText(counts_); }

 private:
  std::map<std::string, int> counts_;
};

/// Reads a bag's messages once. Collects everything but the episodes.
class Reading {
 public:
  Reading(const std::string& path, const rosbag::Bag& bag, const BagReaderOptions& options, BagInspection* inspection)
      : path_(path), options_(options), inspection_(inspection) {
    std::map<std::string, std::uint32_t> counts;
    rosbag::View all(bag);
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      rosbag::View view(bag, [connection](const rosbag::ConnectionInfo* other) { return other->id == connection->id; });
      counts[connection->topic] += view.size();
      AddWrench(*connection);
    }
    std::set<std::string> listed;
    for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
      if (connection->datatype == kWrenchType || wrenches_.count(connection->topic) > 0 ||
          !listed.insert(connection->topic).second)
        continue;
      List(*connection, counts[connection->topic]);
    }
  }

  void Take(const rosbag::MessageInstance& message) {
    const auto wrench = wrenches_.find(message.getTopic());
    if (wrench != wrenches_.end()) {
      wrench->second->Take(message);
    } else if (!options_.wrench_topic.empty() && message.getTopic() == options_.source.joint_states) {
      for (const auto& [name, follower] : wrenches_) follower->Take(message);
    }
    const auto marker = markers_.find(message.getTopic());
    if (marker != markers_.end()) marker->second.Take(message);
  }

  void Finish() {
    for (const auto& [name, wrench] : wrenches_) inspection_->wrenches.push_back(wrench->Result(name));
    for (OtherTopic& marker : inspection_->markers) marker.contents = markers_[marker.name].Contents();
  }

 private:
  /// Follows each WrenchStamped, or only the topic that was asked for, whatever its type.
  void AddWrench(const rosbag::ConnectionInfo& connection) {
    const std::string& wanted = options_.wrench_topic;
    const std::string& topic = connection.topic;
    const bool follow = wanted.empty() ? connection.datatype == kWrenchType : topic == wanted || topic == "/" + wanted;
    if (follow) wrenches_[topic] = std::make_unique<WrenchFollower>(topic, connection.datatype, options_);
  }

  void List(const rosbag::ConnectionInfo& connection, std::uint32_t messages) {
    const OtherTopic topic{connection.topic, connection.datatype, messages, ""};
    if (IsMarker(topic.name, topic.type)) {
      inspection_->markers.push_back(topic);
      markers_[topic.name] = MarkerFollower();
      return;
    }
    inspection_->others.push_back(topic);
    const std::string command = "shapelets train " + path_ + " --model MODEL.bag --wrench-topic " + topic.name;
    if (connection.msg_def.find("geometry_msgs/Wrench") != std::string::npos) {
      inspection_->findings.push_back(
          {core::Severity::kWarning, topic.name + " holds a wrench as part of " + topic.type, command});
    } else if (connection.msg_def.find(" external_torques") != std::string::npos) {
      inspection_->findings.push_back(
          {core::Severity::kWarning, topic.name + " holds external torques of joints",
           command + " --adapter joint_torques --urdf FILE --base-link LINK --tip-link LINK"});
    }
  }

  const std::string& path_;
  const BagReaderOptions& options_;
  BagInspection* inspection_;
  std::map<std::string, std::unique_ptr<WrenchFollower>> wrenches_;
  std::map<std::string, MarkerFollower> markers_;
};

/// Returns the episodes of the bag by the segmentation mode of `options`, or why there are none.
EpisodesFound FindEpisodes(const std::string& path, const std::string& mode, const BagReaderOptions& options) {
  EpisodesFound found;
  found.mode = mode;
  try {
    BagContents contents = ReadEpisodes(path, options);
    found.episodes = std::move(contents.episodes);
    found.dropped = contents.dropped_episodes;
    found.stream = contents.stream;
  } catch (const std::exception& error) {
    found.reason = error.what();
    for (const std::string& prefix : {path + ": ", std::string("expected at least one episode, but ")}) {
      if (found.reason.compare(0, prefix.size(), prefix) == 0) found.reason.erase(0, prefix.size());
    }
  }
  return found;
}

bool HasMarker(const BagInspection& inspection, const std::string& type, const char* name) {
  const auto fits = [&](const OtherTopic& topic) {
    return topic.type == type && (name == nullptr || IsNamed(topic.name, name));
  };
  return std::any_of(inspection.markers.begin(), inspection.markers.end(), fits);
}

void FindAllEpisodes(const std::string& path, BagReaderOptions options, BagInspection* inspection) {
  if (HasMarker(*inspection, kEpisodeType, topics::kEpisode) && options.wrench_topic.empty()) {
    inspection->recorded.push_back(FindEpisodes(path, "recorded", options));
  }
  const bool edges = HasMarker(*inspection, "contact_shapelets/EpisodeEvent", topics::kEpisodeEvent) ||
                     HasMarker(*inspection, "std_msgs/Bool", topics::kEpisodeActive);
  for (WrenchTopic& wrench : inspection->wrenches) {
    options.wrench_topic = wrench.name;
    const auto find = [&](bool possible, const char* name, core::SegmentationMode mode, const char* reason) {
      options.segmentation.segmentation = mode;
      wrench.found.push_back(possible ? FindEpisodes(path, name, options) : EpisodesFound{name, {}, 0, {}, reason});
    };
    find(edges, "trigger", core::SegmentationMode::kTrigger,
         "no episode_active (std_msgs/Bool) or episode_event topic");
    find(true, "contact", core::SegmentationMode::kContact, "");
    find(HasMarker(*inspection, kStatusType, nullptr), "action", core::SegmentationMode::kAction,
         "no actionlib_msgs/GoalStatusArray topic");
  }
}

void JudgeEpisodes(const std::string& where, const EpisodesFound& found, std::vector<core::Finding>* findings) {
  const std::string mode = " (" + found.mode + ")";
  const auto add = [&](std::size_t count, const char* what, const char* remedy) {
    if (count > 0)
      findings->push_back({core::Severity::kWarning, where + Count(count, "episode") + what + mode, remedy});
  };
  if (found.stream.samples == 0) {
    const auto incomplete = std::count_if(found.episodes.begin(), found.episodes.end(),
                                          [](const core::Episode& episode) { return !episode.complete; });
    add(static_cast<std::size_t>(incomplete), " incomplete",
        "samples are missing, or the recording ended too early: let it run until after the last episode");
    add(static_cast<std::size_t>(found.dropped), " dropped", "an episode needs at least two samples");
  }
  if (found.mode == "contact" && found.episodes.empty()) {
    findings->push_back({core::Severity::kWarning, where + found.reason + mode,
                         "begin the recording in free air; check contact_on, or record a trigger"});
  }
  for (const core::Finding& finding : core::EpisodeFindingsOf(found.stream)) {
    findings->push_back({finding.severity, where + finding.text + mode, finding.remedy});
  }
}

void JudgeWrenches(const BagInspection& inspection, const BagReaderOptions& options,
                   std::vector<core::Finding>* findings) {
  for (const WrenchTopic& wrench : inspection.wrenches) {
    for (const core::Finding& finding : core::FindingsOf(wrench.stream)) {
      findings->push_back({finding.severity, wrench.name + ": " + finding.text, finding.remedy});
    }
    const double sample_period = options.segmentation.sample_period;
    if (wrench.stream.rate > 0.0 && wrench.stream.rate * sample_period < kSlow) {
      findings->push_back({core::Severity::kWarning,
                           wrench.name + ": " + Number(wrench.stream.rate, 1) + " Hz is slow for a sample_period of " +
                               Number(sample_period, 3) + " s",
                           "raise the driver's rate to " + Number(0.3 / sample_period, 0) +
                               " Hz or more, or sample_period to " + Number(1.0 / wrench.stream.rate, 3) + " s"});
    }
    for (const EpisodesFound& found : wrench.found) {
      // Without triggers in the bag, contact is one way to look at it; its findings count if the user asked for it.
      const bool asked = options.segmentation.segmentation == core::SegmentationMode::kContact;
      if (asked || found.mode != "contact") JudgeEpisodes(wrench.name + ": ", found, findings);
    }
  }
  if (inspection.wrenches.size() > 1) {
    findings->push_back({core::Severity::kWarning, "several topics of type " + std::string(kWrenchType),
                         "choose one with --wrench-topic"});
  }
}

/// Says why the bag has no wrench to inspect. `topics` are those of the wrench's type.
core::Finding NoWrench(const std::string& wanted, const std::vector<std::string>& topics) {
  const std::string type(kWrenchType);
  if (topics.empty()) {
    return {core::Severity::kWarning, "no topic of type " + type + " or " + kEpisodeType,
            "record the driver's wrench topic (rostopic list -v names the types)"};
  }
  return {core::Severity::kWarning, "no topic " + wanted + " of type " + type,
          "choose one with --wrench-topic: " + Joined(topics, ", ")};
}

void Judge(const BagReaderOptions& options, const BagTopics& topics, BagInspection* inspection) {
  std::vector<core::Finding>& findings = inspection->findings;
  if (inspection->messages == 0) findings.push_back({core::Severity::kWarning, "the bag is empty", "record again"});
  const bool model_file = HasMarker(*inspection, kModelType, nullptr) && inspection->wrenches.empty();
  if (model_file || inspection->messages == 0) return;
  JudgeWrenches(*inspection, options, &findings);
  for (const EpisodesFound& found : inspection->recorded) JudgeEpisodes("", found, &findings);
  if (!inspection->recorded.empty()) return;
  if (inspection->wrenches.empty()) {
    findings.push_back(NoWrench(options.wrench_topic, topics.OfType(kWrenchType)));
    return;
  }
  const std::vector<EpisodesFound>& found = inspection->wrenches.front().found;
  const auto has_episodes = [](const EpisodesFound& each) { return each.mode != "contact" && !each.episodes.empty(); };
  if (std::none_of(found.begin(), found.end(), has_episodes)) {
    const bool contact =
        std::any_of(found.begin(), found.end(), [](const auto& each) { return !each.episodes.empty(); });
    findings.push_back({core::Severity::kWarning, "no episode markers",
                        contact ? "record episode_active beside the wrench, or use --segmentation contact"
                                : "record episode_active (std_msgs/Bool) beside the wrench"});
  } else if (!HasMarker(*inspection, "std_msgs/String", topics::kOutcome)) {
    findings.push_back({core::Severity::kWarning, "no outcome topic",
                        "training does not need it; without it, name clusters by hand; they get no scores"});
  }
}

/// Reads the model of a model file. A topic with several models belongs to a recording.
void ReadModel(const std::string& path, BagInspection* inspection) {
  const auto is_model = [](const OtherTopic& topic) { return topic.type == kModelType && topic.messages == 1; };
  if (std::none_of(inspection->markers.begin(), inspection->markers.end(), is_model)) return;
  try {
    inspection->model = LoadModel(path);
  } catch (const std::exception& error) {
    inspection->findings.push_back(
        {core::Severity::kWarning, error.what(), "train again with this version of the package"});
  }
}

}  // namespace

BagInspection InspectBag(const std::string& path, const BagReaderOptions& options, const ReadProgress& progress) {
  BagDamage damage(path);
  rosbag::Bag bag;
  OpenBag(path, &bag);
  BagInspection inspection;
  inspection.size = bag.getSize();
  try {
    rosbag::View view(bag);
    inspection.messages = view.size();
    if (inspection.messages > 0) {
      inspection.begin = ToNanoseconds(view.getBeginTime());
      inspection.end = ToNanoseconds(view.getEndTime());
    }
    Reading reading(path, bag, options, &inspection);
    double taken = 0.0;
    for (const rosbag::MessageInstance& message : view) {
      reading.Take(message);
      if (progress && static_cast<int>(++taken) % 4096 == 0) progress(taken / inspection.messages);
    }
    reading.Finish();
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": expected a whole bag, but it is damaged: " + error.what());
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  ReadModel(path, &inspection);
  FindAllEpisodes(path, options, &inspection);
  Judge(options, BagTopics(bag), &inspection);
  return inspection;
}

}  // namespace contact_shapelets::cli
