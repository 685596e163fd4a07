#include "contact_shapelets/core/segmentation_options.h"

#include <sstream>

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets::core {

std::string SegmentationOptions::Faults() const {
  std::ostringstream faults;
  const auto require = [&faults](bool well, const char* name, const char* range, double value) {
    if (!well) faults << name << " must be " << range << ", but is " << value << '\n';
  };
  require(IsSamplePeriod(sample_period), "sample_period", "in [0.0001, 1] s", sample_period);
  require(tare_duration > 0.0 && tare_duration <= 10.0, "tare_duration", "in (0, 10] s", tare_duration);
  require(min_duration >= 2.0 * sample_period, "min_duration", "at least 2 sample periods", min_duration);
  require(max_duration > min_duration && max_duration <= 600.0, "max_duration", "above min_duration, at most 600 s",
          max_duration);
  require(max_gap > 0.0, "max_gap", "above 0 s", max_gap);
  require(stream_timeout > max_gap && stream_timeout <= 60.0, "stream_timeout", "above max_gap, at most 60 s",
          stream_timeout);
  require(edge_wait >= 0.0 && edge_wait <= 1.0, "edge_wait", "in [0, 1] s", edge_wait);
  require(edge_match_window >= 0.0 && edge_match_window <= 5.0, "edge_match_window", "in [0, 5] s", edge_match_window);
  require(contact_off > 0.0, "contact_off", "above 0 N", contact_off);
  require(contact_on > contact_off && contact_on <= kGreatestForce, "contact_on", "above contact_off, at most 1e6 N",
          contact_on);
  require(contact_hold_on >= 0.0 && contact_hold_on <= 1.0, "contact_hold_on", "in [0, 1] s", contact_hold_on);
  require(contact_hold_off >= 0.0 && contact_hold_off <= 10.0, "contact_hold_off", "in [0, 10] s", contact_hold_off);
  require(pre_trigger >= 0.0 && pre_trigger <= 10.0, "pre_trigger", "in [0, 10] s", pre_trigger);
  require(baseline_duration > 0.0 && baseline_duration <= 60.0, "baseline_duration", "in (0, 60] s", baseline_duration);
  return faults.str();
}

}  // namespace contact_shapelets::core
