#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/segmentation_options.h"

/// \file
/// How a model's training episodes were made, so that new ones are made alike. Preparation.msg has the same fields.

namespace contact_shapelets::core {

/// The segmentation of the training episodes, and the ranges that they cover.
struct Preparation {
  std::optional<SegmentationOptions> segmentation;  ///< how they were cut; nothing if unknown
  std::string topic;                                ///< topic of their wrench; empty if unknown
  std::string frame_id;                             ///< frame of their wrench
  double rate = 0.0;                                ///< [Hz] mean rate of the wrench, [0, 1e6]; 0 if unknown
  double least_duration = 0.0;                      ///< [s] of the shortest episode, [0, 1e7]
  double greatest_duration = 0.0;                   ///< [s] of the longest, [0, 1e7]; 0 if the ranges are unknown
  double least_peak = 0.0;                          ///< [N] least of the episodes' greatest forces, [0, 2e6]
  double greatest_peak = 0.0;                       ///< [N] greatest of these, [0, 2e6]

  /// Sets frame and ranges to those of `episodes`.
  void SetRanges(const std::vector<Episode>& episodes);

  /// Returns in words how far `episode` is from all training episodes, such as "it lasts 1.8 s, in training 5.2 to
  /// 7.9 s"; an empty string if it is near to one or the ranges are unknown. Far is a duration by more than a half
  /// beyond the range, a peak of the force of less than half the least or more than twice the greatest, or a sample
  /// period of more than twice or less than half of `sample_period` [s], the model's.
  std::string FarFrom(const Episode& episode, double sample_period) const;

  /// Returns every fault, one per line; an empty string if all fields are in their bounds.
  std::string Faults() const;
};

/// Returns what two parts of a training have in common: a segmentation, topic or rate that differs is unknown.
Preparation InCommon(const Preparation& first, const Preparation& second);

/// Returns a name and both values for each parameter that differs: "contact_on 8 (trained with 6), ..."; an empty
/// string if none does. Ignores the parameters that `used.segmentation` does not read, and the sample period, to which
/// a classifier resamples.
std::string DifferencesOf(const SegmentationOptions& used, const SegmentationOptions& trained);

/// Returns "trigger", "contact" or "action".
std::string NameOf(SegmentationMode mode);
/// Returns "episode_start", "free_air" or "service".
std::string NameOf(TareSource tare);

}  // namespace contact_shapelets::core
