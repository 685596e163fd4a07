#include "ros/messages/missing_input.h"

#include <gtest/gtest.h>

namespace contact_shapelets {
namespace {

std::vector<std::string> TwoTopics() { return {"/ft_sensor", "/iiwa/wrench"}; }
std::vector<std::string> NoTopics() { return {}; }

ReceivedInput Input(bool wrench, double waited, double duration) {
  return {wrench, false, waited, duration, "/wrench", "/episode_active and /episode_event"};
}

TEST(MissingInput, SaysNothingBeforeTheTimeIsUp) {
  EXPECT_EQ(MissingInput(Input(false, 4.9, 0.0), TwoTopics), "");
  EXPECT_EQ(MissingInput(Input(true, 0.0, 59.0), TwoTopics), "");
}

TEST(MissingInput, NamesTheTopicWithoutAWrenchAndTheOthersOfItsType) {
  EXPECT_NE(MissingInput(Input(false, 5.0, 0.0), TwoTopics).find("no wrench yet on /wrench"), std::string::npos);
  EXPECT_NE(MissingInput(Input(false, 5.0, 0.0), TwoTopics).find("/ft_sensor /iiwa/wrench"), std::string::npos);
  EXPECT_NE(MissingInput(Input(false, 5.0, 0.0), NoTopics).find("none"), std::string::npos);
}

TEST(MissingInput, NamesTheTopicsWithoutATriggerAndTheModeThatNeedsNone) {
  const std::string text = MissingInput(Input(true, 0.0, 60.0), NoTopics);
  EXPECT_NE(text.find("/episode_active and /episode_event"), std::string::npos) << text;
  EXPECT_NE(text.find("segmentation:=contact"), std::string::npos) << text;
}

TEST(MissingInput, MissesNoTriggerAfterOneCameOrInContactMode) {
  ReceivedInput triggered = Input(true, 0.0, 3600.0);
  triggered.edge = true;
  EXPECT_EQ(MissingInput(triggered, NoTopics), "");
  ReceivedInput contact = Input(true, 0.0, 3600.0);
  contact.trigger_topics = "";
  EXPECT_EQ(MissingInput(contact, NoTopics), "");
}

}  // namespace
}  // namespace contact_shapelets
