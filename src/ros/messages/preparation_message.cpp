#include "ros/messages/preparation_message.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace contact_shapelets {
namespace {

using core::SegmentationMode;
using core::SegmentationOptions;
using core::TareSource;

constexpr std::array<std::pair<double Preparation::*, double SegmentationOptions::*>, 14> kNumbers{{
    {&Preparation::sample_period, &SegmentationOptions::sample_period},
    {&Preparation::tare_duration, &SegmentationOptions::tare_duration},
    {&Preparation::min_duration, &SegmentationOptions::min_duration},
    {&Preparation::max_duration, &SegmentationOptions::max_duration},
    {&Preparation::max_gap, &SegmentationOptions::max_gap},
    {&Preparation::stream_timeout, &SegmentationOptions::stream_timeout},
    {&Preparation::edge_wait, &SegmentationOptions::edge_wait},
    {&Preparation::edge_match_window, &SegmentationOptions::edge_match_window},
    {&Preparation::contact_on, &SegmentationOptions::contact_on},
    {&Preparation::contact_off, &SegmentationOptions::contact_off},
    {&Preparation::contact_hold_on, &SegmentationOptions::contact_hold_on},
    {&Preparation::contact_hold_off, &SegmentationOptions::contact_hold_off},
    {&Preparation::pre_trigger, &SegmentationOptions::pre_trigger},
    {&Preparation::baseline_duration, &SegmentationOptions::baseline_duration},
}};

/// Returns the one of `choices` with the name `word`.
template <typename Choice>
Choice ChoiceOf(const std::string& what, const std::string& word, std::initializer_list<Choice> choices) {
  for (const Choice choice : choices) {
    if (core::NameOf(choice) == word) return choice;
  }
  throw std::invalid_argument("the model's " + what + " is \"" + word + "\", which this version does not know");
}

}  // namespace

Preparation ToMessage(const core::Preparation& preparation) {
  Preparation message;
  if (preparation.segmentation) {
    message.segmentation = core::NameOf(preparation.segmentation->segmentation);
    message.tare = core::NameOf(preparation.segmentation->tare);
    for (const auto& [to, from] : kNumbers) message.*to = (*preparation.segmentation).*from;
  }
  message.topic = preparation.topic;
  message.frame_id = preparation.frame_id;
  message.rate = preparation.rate;
  message.least_duration = preparation.least_duration;
  message.greatest_duration = preparation.greatest_duration;
  message.least_peak = preparation.least_peak;
  message.greatest_peak = preparation.greatest_peak;
  return message;
}

core::Preparation FromMessage(const Preparation& message) {
  core::Preparation preparation;
  if (!message.segmentation.empty()) {
    SegmentationOptions& options = preparation.segmentation.emplace();
    options.segmentation =
        ChoiceOf("segmentation", message.segmentation,
                 {SegmentationMode::kTrigger, SegmentationMode::kContact, SegmentationMode::kAction});
    options.tare =
        ChoiceOf("tare", message.tare, {TareSource::kEpisodeStart, TareSource::kFreeAir, TareSource::kService});
    for (const auto& [from, to] : kNumbers) options.*to = message.*from;
  }
  preparation.topic = message.topic;
  preparation.frame_id = message.frame_id;
  preparation.rate = message.rate;
  preparation.least_duration = message.least_duration;
  preparation.greatest_duration = message.greatest_duration;
  preparation.least_peak = message.least_peak;
  preparation.greatest_peak = message.greatest_peak;
  return preparation;
}

}  // namespace contact_shapelets
