#include "contact_shapelets/core/preparation.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "contact_shapelets/core/model.h"
#include "core/numerics/interval.h"

namespace contact_shapelets::core {
namespace {

constexpr double kFarDuration = 1.5;
constexpr double kFarPeak = 2.0;
constexpr double kFarPeriod = 2.0;

constexpr Interval kDurations{0.0, 1e7};
constexpr Interval kPeaks{0.0, 2.0 * kGreatestForce};
constexpr Interval kRates{0.0, 1e6};

struct NamedMember {
  const char* name;
  double SegmentationOptions::*member;
};

constexpr std::array<NamedMember, 7> kCommonMembers{{
    {"tare_duration", &SegmentationOptions::tare_duration},
    {"min_duration", &SegmentationOptions::min_duration},
    {"max_duration", &SegmentationOptions::max_duration},
    {"max_gap", &SegmentationOptions::max_gap},
    {"stream_timeout", &SegmentationOptions::stream_timeout},
    {"edge_wait", &SegmentationOptions::edge_wait},
    {"edge_match_window", &SegmentationOptions::edge_match_window},
}};
constexpr std::array<NamedMember, 6> kContactMembers{{
    {"contact_on", &SegmentationOptions::contact_on},
    {"contact_off", &SegmentationOptions::contact_off},
    {"contact_hold_on", &SegmentationOptions::contact_hold_on},
    {"contact_hold_off", &SegmentationOptions::contact_hold_off},
    {"pre_trigger", &SegmentationOptions::pre_trigger},
    {"baseline_duration", &SegmentationOptions::baseline_duration},
}};

/// Collects parts of a sentence.
class Parts {
 public:
  template <typename Value>
  void Add(const std::string& name, const Value& used, const Value& trained) {
    if (used == trained) return;
    text_ << (text_.tellp() > 0 ? ", " : "") << name << ' ' << used << " (trained with " << trained << ')';
  }
  std::string Text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

bool IsFar(double value, double least, double greatest, double factor) {
  return value * factor < least || value > greatest * factor;
}

}  // namespace

void Preparation::SetRanges(const std::vector<Episode>& episodes) {
  if (episodes.empty()) return;
  std::vector<double> durations;
  std::vector<double> peaks;
  for (const Episode& episode : episodes) {
    durations.push_back(episode.duration());
    peaks.push_back(episode.force.size() > 0 ? static_cast<double>(episode.force.maxCoeff()) : 0.0);
  }
  const auto [shortest, longest] = std::minmax_element(durations.begin(), durations.end());
  const auto [weakest, strongest] = std::minmax_element(peaks.begin(), peaks.end());
  frame_id = episodes.front().frame_id;
  least_duration = *shortest;
  greatest_duration = *longest;
  least_peak = std::max(0.0, *weakest);
  greatest_peak = std::max(0.0, *strongest);
}

std::string Preparation::FarFrom(const Episode& episode, double sample_period) const {
  if (greatest_duration <= 0.0 || episode.force.size() == 0) return "";
  std::ostringstream text;
  text << std::setprecision(3);
  const auto add = [&text](const char* what, double value, double least, double greatest, const char* unit) {
    text << (text.tellp() > 0 ? "; " : "") << what << ' ' << value << unit << ", in training " << least << " to "
         << greatest << unit;
  };
  const auto peak = static_cast<double>(episode.force.maxCoeff());
  if (IsFar(episode.duration(), least_duration, greatest_duration, kFarDuration)) {
    add("it lasts", episode.duration(), least_duration, greatest_duration, " s");
  }
  if (IsFar(peak, least_peak, greatest_peak, kFarPeak)) {
    add("its greatest force is", peak, least_peak, greatest_peak, " N");
  }
  if (IsFar(episode.sample_period, sample_period, sample_period, kFarPeriod)) {
    text << (text.tellp() > 0 ? "; " : "") << "its sample period is " << episode.sample_period << " s, in training "
         << sample_period << " s";
  }
  return text.str();
}

std::string Preparation::Faults() const {
  std::ostringstream faults;
  if (segmentation) faults << segmentation->Faults();
  if (topic.size() > kLongestPath) faults << "the topic has more than " << kLongestPath << " bytes\n";
  if (frame_id.size() > kLongestPath) faults << "the frame has more than " << kLongestPath << " bytes\n";
  CheckRange("the rate", rate, kRates, &faults, " Hz");
  CheckRange("the least duration", least_duration, kDurations, &faults, " s");
  CheckRange("the greatest duration", greatest_duration, kDurations, &faults, " s");
  CheckRange("the least peak", least_peak, kPeaks, &faults, " N");
  CheckRange("the greatest peak", greatest_peak, kPeaks, &faults, " N");
  return faults.str();
}

Preparation InCommon(const Preparation& first, const Preparation& second) {
  Preparation common = first;
  const bool alike =
      first.segmentation && second.segmentation && DifferencesOf(*first.segmentation, *second.segmentation).empty();
  if (!alike) common.segmentation.reset();
  if (first.topic != second.topic) common.topic.clear();
  common.rate = first.rate > 0.0 && second.rate > 0.0 ? (first.rate + second.rate) / 2.0 : 0.0;
  return common;
}

std::string DifferencesOf(const SegmentationOptions& used, const SegmentationOptions& trained) {
  Parts parts;
  parts.Add("segmentation", NameOf(used.segmentation), NameOf(trained.segmentation));
  parts.Add("tare", NameOf(used.tare), NameOf(trained.tare));
  for (const auto& [name, member] : kCommonMembers) parts.Add(name, used.*member, trained.*member);
  if (used.segmentation == SegmentationMode::kContact) {
    for (const auto& [name, member] : kContactMembers) parts.Add(name, used.*member, trained.*member);
  }
  return parts.Text();
}

std::string NameOf(SegmentationMode mode) {
  if (mode == SegmentationMode::kContact) return "contact";
  return mode == SegmentationMode::kAction ? "action" : "trigger";
}

std::string NameOf(TareSource tare) {
  if (tare == TareSource::kFreeAir) return "free_air";
  return tare == TareSource::kService ? "service" : "episode_start";
}

}  // namespace contact_shapelets::core
