#pragma once

#include <string>

/// \file
/// Parameters of the segmentation into episodes.

namespace contact_shapelets::core {

/// What opens and closes an episode.
enum class SegmentationMode {
  kTrigger,  ///< a topic or service of the sequencer
  kContact,  ///< the contact force itself
  kAction,   ///< the status of an action server
};

/// Which force counts as zero.
enum class TareSource {
  kEpisodeStart,  ///< the mean over the first part of the episode
  kFreeAir,       ///< the mean over the time before the episode
  kService,       ///< the last measurement of the tare service; zero before the first
};

/// Parameters of EpisodeSegmenter. The defaults suit the wrench estimate of an iiwa, which is 1 to 5 N off in free air.
struct SegmentationOptions {
  SegmentationMode segmentation = SegmentationMode::kTrigger;  ///< what opens and closes an episode
  TareSource tare = TareSource::kEpisodeStart;                 ///< which force counts as zero
  double sample_period = 0.01;                                 ///< [s] between samples of an episode, [0.0001, 1]
  double tare_duration = 0.1;                                  ///< [s] over which the tare is the mean, (0, 10]
  double min_duration = 0.1;        ///< [s] drops shorter episodes, at least 2 sample periods
  double max_duration = 30.0;       ///< [s] closes longer episodes, above min_duration, at most 600
  double max_gap = 0.2;             ///< [s] a longer gap between samples makes an episode incomplete, above 0
  double stream_timeout = 1.0;      ///< [s] without a sample closes an open episode, above max_gap, at most 60
  double edge_wait = 0.05;          ///< [s] how long a closing edge waits for samples from before it, [0, 1]
  double edge_match_window = 0.25;  ///< [s] between a stamped and an unstamped edge that count as one, [0, 5]
  double contact_on = 8.0;          ///< [N] contact begins above it, above contact_off, at most 1e6
  double contact_off = 4.0;         ///< [N] contact ends below it, above 0
  double contact_hold_on = 0.005;   ///< [s] how long the force must stay above contact_on, [0, 1]
  double contact_hold_off = 0.2;    ///< [s] how long the force must stay below contact_off, [0, 10]
  double pre_trigger = 0.5;         ///< [s] how long before the contact an episode begins, [0, 10]
  double baseline_duration = 1.0;   ///< [s] time constant of the running mean in free air, (0, 60]

  /// Returns one line with name and range for each parameter that is out of range; an empty string if all are valid.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
