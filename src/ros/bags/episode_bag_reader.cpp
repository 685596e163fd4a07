#include "contact_shapelets/ros/episode_bag_reader.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "contact_shapelets/core/cancelled.h"
#include "contact_shapelets/core/wrench_stream.h"
#include "ros/bags/bag_damage.h"
#include "ros/bags/bag_topics.h"
#include "ros/bags/wrench_messages.h"
#include "ros/messages/action_edges.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publisher_watch.h"

namespace contact_shapelets {
namespace {

/// The topics to read; a name is empty if the bag has no such topic.
struct Parts {
  std::string wrench;
  std::string active;
  std::string event;
  std::string status;
  std::string tare;
  std::string outcome;
  std::string episode;
};

std::string AtMostOne(const std::string& path, const std::vector<std::string>& topics, const std::string& what) {
  if (topics.size() > 1) {
    throw std::runtime_error(path + ": expected one " + what + " topic, but found " + Joined(topics) +
                             "; keep one by `rosbag filter`");
  }
  return topics.empty() ? "" : topics.front();
}

Parts FindParts(const std::string& path, const BagTopics& topics, const BagReaderOptions& options) {
  Parts parts;
  parts.outcome = AtMostOne(path, topics.Named(topics::kOutcome, "std_msgs/String"), "outcome");
  if (options.wrench_topic.empty()) {
    parts.episode = AtMostOne(path, topics.Named(topics::kEpisode, "contact_shapelets/Episode"), "episode");
    if (!parts.episode.empty()) return parts;
  }
  parts.wrench = WrenchTopicOf(path, topics, options.wrench_topic);
  parts.tare = AtMostOne(path, topics.Named(topics::kTare, "contact_shapelets/Tare"), "tare");
  if (options.segmentation.segmentation == core::SegmentationMode::kTrigger) {
    parts.event =
        AtMostOne(path, topics.Named(topics::kEpisodeEvent, "contact_shapelets/EpisodeEvent"), "episode_event");
    parts.active = AtMostOne(path, topics.Named(topics::kEpisodeActive, "std_msgs/Bool"), "episode_active");
  }
  if (options.segmentation.segmentation == core::SegmentationMode::kAction) {
    parts.status = AtMostOne(path, topics.OfType("actionlib_msgs/GoalStatusArray"), "action status");
  }
  return parts;
}

/// Cuts one bag into episodes. Takes its messages in the order of arrival.
class Reading {
 public:
  Reading(const Parts& parts, const BagReaderOptions& options) : parts_(parts), stream_(options.segmentation) {
    if (!parts.wrench.empty()) wrenches_.emplace(parts.wrench, options.source);
  }

  void Take(const rosbag::MessageInstance& message) {
    const std::string& topic = message.getTopic();
    const core::Nanoseconds arrival = ToNanoseconds(message.getTime());
    // The node lets time pass between messages too.
    stream_.AdvanceTo(arrival);
    if (wrenches_ && wrenches_->Reads(topic)) {
      if (const auto wrench = wrenches_->Read(message)) {
        if (const auto publisher = publisher_.Next(message.getConnectionHeader())) stream_.SetPublisher(*publisher);
        TakeWrench(*wrench, arrival);
      }
    } else if (topic == parts_.active) {
      stream_.AddUnstampedEdge(Instantiate<std_msgs::Bool>(message)->data != 0, arrival);
    } else if (topic == parts_.event) {
      const auto event = Instantiate<EpisodeEvent>(message);
      stream_.AddStampedEdge(event->kind == EpisodeEvent::OPEN, ToNanoseconds(event->header.stamp), event->episode_id,
                             arrival, PublisherWatch::NameOf(message.getConnectionHeader()));
    } else if (topic == parts_.status) {
      stream_.AddStatus(AnyGoalActive(*Instantiate<actionlib_msgs::GoalStatusArray>(message)), arrival);
    } else if (topic == parts_.tare) {
      stream_.SetTare(ToVector(Instantiate<Tare>(message)->force));
    } else if (topic == parts_.episode) {
      TakeEpisode(FromMessage(*Instantiate<Episode>(message)), arrival);
    } else if (topic == parts_.outcome) {
      outcomes_.push_back({Instantiate<std_msgs::String>(message)->data, arrival});
    }
    Collect();
  }

  BagContents Finish() {
    if (!has_frame_ && wrenches_ && !wrenches_->fault().empty()) throw std::runtime_error(wrenches_->fault());
    stream_.Finish();
    Collect();
    NameOutcomes();
    contents_.stream = stream_.Summary();
    contents_.dropped_episodes += static_cast<int>(core::DroppedEpisodes(contents_.stream));
    return contents_;
  }

 private:
  /// A closed episode and its outcome. Ids may repeat, and the segmentation may drop closed episodes.
  struct Closing {
    std::string id;
    core::Nanoseconds opened = 0;   ///< arrival of its opening
    core::Nanoseconds arrival = 0;  ///< when the episode was over
    std::string outcome;
  };
  struct Outcome {
    std::string text;
    core::Nanoseconds arrival = 0;
  };

  template <typename Message>
  static typename Message::ConstPtr Instantiate(const rosbag::MessageInstance& instance) {
    typename Message::ConstPtr message = instance.instantiate<Message>();
    if (!message) {
      throw std::runtime_error(instance.getTopic() + " holds " + instance.getDataType() + " of another version (MD5 " +
                               instance.getMD5Sum() + ", expected " + ros::message_traits::md5sum<Message>() + ")");
    }
    return message;
  }

  void TakeWrench(const geometry_msgs::WrenchStamped& wrench, core::Nanoseconds arrival) {
    if (!has_frame_) {
      stream_.set_frame_id(wrench.header.frame_id);
      has_frame_ = true;
    }
    stream_.AddWrench(ToNanoseconds(wrench.header.stamp), arrival, ToVector(wrench.wrench.force));
  }

  void TakeEpisode(core::Episode episode, core::Nanoseconds arrival) {
    closings_.push_back({episode.id, arrival, arrival, ""});
    if (episode.force.size() < 2) {
      ++contents_.dropped_episodes;
    } else {
      contents_.episodes.push_back(std::move(episode));
    }
  }

  /// Gives each outcome to the last episode that was over before it. A contact is over before `contact_hold_off` ends.
  /// Episodes come in the order of their closings. If that episode has an outcome, and the next one is open, the
  /// outcome is that of an episode whose closing was lost. It names none, because that episode is incomplete.
  void NameOutcomes() {
    for (const Outcome& outcome : outcomes_) {
      const auto later = std::find_if(closings_.begin(), closings_.end(),
                                      [&](const Closing& closing) { return closing.arrival > outcome.arrival; });
      if (later == closings_.begin()) continue;
      Closing& last = *std::prev(later);
      const bool next_is_open = later != closings_.end() && later->opened <= outcome.arrival;
      if (last.outcome.empty() || !next_is_open) last.outcome = outcome.text;
    }
    auto closing = closings_.begin();
    for (core::Episode& episode : contents_.episodes) {
      closing = std::find_if(closing, closings_.end(), [&](const Closing& other) { return other.id == episode.id; });
      if (closing == closings_.end()) return;
      if (episode.outcome.empty()) episode.outcome = closing->outcome;
      ++closing;
    }
  }

  void Collect() {
    if (!stream_.HasNews()) return;
    for (const core::EpisodeEdge& edge : stream_.TakeEdges()) {
      if (edge.open) {
        opened_ = edge.arrival;
      } else {
        closings_.push_back({edge.id, opened_, edge.arrival, ""});
      }
    }
    for (core::Episode& episode : stream_.TakeEpisodes()) contents_.episodes.push_back(std::move(episode));
  }

  Parts parts_;
  std::optional<WrenchMessages> wrenches_;  ///< nothing if Episode messages are read
  core::WrenchStream stream_;
  BagContents contents_;
  PublisherWatch publisher_;
  core::Nanoseconds opened_ = 0;  ///< arrival of the last opening
  std::vector<Closing> closings_;
  std::vector<Outcome> outcomes_;
  bool has_frame_ = false;
};

std::string WhyNoEpisode(const BagReaderOptions& options, const Parts& parts, const core::StreamSummary& stream) {
  switch (options.segmentation.segmentation) {
    case core::SegmentationMode::kContact:
      if (stream.without_baseline > 0.0) return "the force of " + parts.wrench + " never rests: no free air is found";
      return "no contact above contact_on was found in " + parts.wrench;
    case core::SegmentationMode::kAction:
      return parts.status.empty() ? "it has no topic of type actionlib_msgs/GoalStatusArray" : "no goal was active";
    case core::SegmentationMode::kTrigger:
      break;
  }
  if (!parts.episode.empty()) return parts.episode + " holds none of at least 2 samples";
  const bool triggers = !parts.active.empty() || !parts.event.empty();
  return triggers ? "its triggers open none that is long enough"
                  : "it has no episode_active (std_msgs/Bool) or episode_event topic; try segmentation: contact";
}

core::Preparation PreparationOf(const BagContents& contents, const Parts& parts, const BagReaderOptions& options) {
  core::Preparation preparation;
  if (!parts.wrench.empty()) {
    preparation.segmentation = options.segmentation;
    preparation.topic = parts.wrench;
    preparation.rate = contents.stream.rate;
  }
  preparation.SetRanges(contents.episodes);
  return preparation;
}

}  // namespace

BagContents ReadEpisodes(const std::string& path, const BagReaderOptions& options, const ReadProgress& progress) {
  BagDamage damage(path);
  rosbag::Bag bag;
  OpenBag(path, &bag);
  const BagTopics topics(bag);
  const Parts parts = FindParts(path, topics, options);
  std::vector<std::string> wanted;
  for (const std::string& topic :
       {parts.wrench, parts.active, parts.event, parts.status, parts.tare, parts.outcome, parts.episode}) {
    if (!topic.empty()) wanted.push_back(topic);
  }
  if (options.source.adapter.from_torques) wanted.push_back(options.source.joint_states);
  BagContents contents;
  try {
    Reading reading(parts, options);
    rosbag::View view(bag, rosbag::TopicQuery(wanted));
    const double total = view.size();
    double taken = 0.0;
    for (const rosbag::MessageInstance& message : view) {
      reading.Take(message);
      if (progress && static_cast<int>(++taken) % 4096 == 0) progress(taken / total);
    }
    contents = reading.Finish();
  } catch (const core::Cancelled&) {
    throw;
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": expected a whole bag, but it is damaged: " + error.what());
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (contents.episodes.empty()) {
    throw std::runtime_error(path + ": expected at least one episode, but " +
                             WhyNoEpisode(options, parts, contents.stream));
  }
  contents.preparation = PreparationOf(contents, parts, options);
  if (progress) progress(1.0);
  return contents;
}

std::vector<core::Episode> ReadAllEpisodes(const std::vector<std::string>& paths, const BagReaderOptions& options,
                                           const ReadProgress& progress, core::Preparation* preparation) {
  if (paths.empty()) throw std::runtime_error("expected at least one bag, but none was given");
  std::vector<core::Episode> episodes;
  core::Preparation common;
  for (std::size_t index = 0; index < paths.size(); ++index) {
    const auto part = [&](double done) {
      if (progress) progress((static_cast<double>(index) + done) / static_cast<double>(paths.size()));
    };
    BagContents contents = ReadEpisodes(paths[index], options, part);
    common = index == 0 ? contents.preparation : core::InCommon(common, contents.preparation);
    std::move(contents.episodes.begin(), contents.episodes.end(), std::back_inserter(episodes));
  }
  common.SetRanges(episodes);
  if (preparation != nullptr) *preparation = common;
  return episodes;
}

}  // namespace contact_shapelets
