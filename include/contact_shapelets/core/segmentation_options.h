#pragma once

#include <string>

/// \file
/// Parameters of the segmentation into episodes.

namespace contact_shapelets::core {

/// What opens and closes an episode.
enum class Segmentation {
  kTrigger,  ///< a topic or service of the sequencer
  kContact,  ///< the contact force itself
  kAction,   ///< the status of an action server
};

/// Which force is taken for zero.
enum class TareSource {
  kEpisodeStart,  ///< the mean over the first part of the episode
  kFreeAir,       ///< the mean over the time before the episode
  kService,       ///< what the tare service measured last; zero before
};

/// Parameters of EpisodeSegmenter. Defaults suit an iiwa's estimate: 1 to 5 N off in free air.
struct SegmentationOptions {
  Segmentation segmentation = Segmentation::kTrigger;  ///< what opens and closes an episode
  TareSource tare = TareSource::kEpisodeStart;         ///< which force is taken for zero
  double sample_period = 0.01;                         ///< [s] of the episodes, [0.0001, 1]
  double tare_duration = 0.1;                          ///< [s] that the tare is the mean of, (0, 10]
  double min_duration = 0.1;                           ///< [s] shorter episodes are dropped, at least 2 sample periods
  double max_duration = 30.0;       ///< [s] longer episodes are closed, above min_duration, at most 600
  double max_gap = 0.2;             ///< [s] between samples, beyond which an episode is not complete, above 0
  double stream_timeout = 1.0;      ///< [s] without a sample, after which an open episode is closed, above max_gap
  double edge_wait = 0.05;          ///< [s] to wait for samples before a closing edge, [0, 1]
  double edge_match_window = 0.25;  ///< [s] within which a stamped opening corrects the one before, [0, 5]
  double contact_on = 8.0;          ///< [N] contact begins above, greater than contact_off
  double contact_off = 4.0;         ///< [N] contact ends below, above 0
  double contact_hold_on = 0.005;   ///< [s] that the force must be above, [0, 1]
  double contact_hold_off = 0.2;    ///< [s] that the force must be below, [0, 10]
  double pre_trigger = 0.5;         ///< [s] before the contact that belong to the episode, [0, 10]
  double baseline_duration = 1.0;   ///< [s] time constant of the running mean in free air, (0, 60]

  /// Every parameter that is out of range, one line each with its name and range; empty where all are well.
  std::string Faults() const;
};

}  // namespace contact_shapelets::core
