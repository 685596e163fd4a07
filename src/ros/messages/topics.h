#pragma once

#include <cstdint>

/// \file
/// All topic names, relative, with their queue sizes.

namespace contact_shapelets {
namespace topics {

constexpr char kWrench[] = "wrench";
constexpr char kEpisodeActive[] = "episode_active";
constexpr char kEpisodeEvent[] = "episode_event";
constexpr char kActionStatus[] = "action_status";
constexpr char kTare[] = "tare";
constexpr char kOutcome[] = "outcome";
constexpr char kEpisode[] = "episode";
constexpr char kEpisodeProgress[] = "episode_progress";
constexpr char kModel[] = "model";
constexpr char kFeatures[] = "features";
constexpr char kDiagnosis[] = "diagnosis";
constexpr char kEvent[] = "event";
/// Of the wrench adapter: what the driver has in place of `wrench`.
constexpr char kDriverMessage[] = "driver_message";
constexpr char kJointStates[] = "joint_states";

/// Two seconds of a 1 kHz stream, so that a busy moment loses no sample.
constexpr std::uint32_t kWrenchQueue = 2000;
constexpr std::uint32_t kEdgeQueue = 100;
constexpr std::uint32_t kResultQueue = 100;
/// Only the newest state of an open episode matters.
constexpr std::uint32_t kProgressQueue = 1;

}  // namespace topics
}  // namespace contact_shapelets
