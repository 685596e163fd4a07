#include "ros/messages/missing_input.h"

namespace contact_shapelets {
namespace {

constexpr double kNoWrench = 5.0;
constexpr double kNoTrigger = 60.0;

}  // namespace

std::string MissingInput(const ReceivedInput& input, const std::function<std::vector<std::string>()>& other_wrenches) {
  if (!input.wrench) {
    if (input.waited < kNoWrench) return "";
    std::string text = "no wrench yet on " + input.wrench_topic +
                       ": start the driver, or remap the topic wrench. Topics of this type:";
    const std::vector<std::string> topics = other_wrenches();
    for (const std::string& topic : topics) text += " " + topic;
    return topics.empty() ? text + " none" : text;
  }
  if (input.edge || input.trigger_topics.empty() || input.duration < kNoTrigger) return "";
  return "no trigger yet on " + input.trigger_topics +
         ", so no episode opens: start the sequencer, or use segmentation:=contact, which needs no trigger";
}

}  // namespace contact_shapelets
