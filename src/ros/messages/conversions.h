#pragma once

#include <contact_shapelets/Diagnosis.h>
#include <contact_shapelets/Episode.h>
#include <contact_shapelets/EpisodeEvent.h>
#include <contact_shapelets/ShapeletFeatures.h>
#include <contact_shapelets/ShapeletModel.h>
#include <contact_shapelets/Tare.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>

#include <Eigen/Core>

#include "contact_shapelets/core/classifier.h"
#include "contact_shapelets/core/episode.h"
#include "contact_shapelets/core/episode_edge.h"
#include "contact_shapelets/core/model.h"

/// \file
/// Between messages and the core's types of the same meaning.

namespace contact_shapelets {

/// Nanoseconds since the epoch.
core::Nanoseconds ToNanoseconds(const ros::Time& time);
/// The time of `nanoseconds` since the epoch; negative ones become zero.
ros::Time ToTime(core::Nanoseconds nanoseconds);
/// The time on the machine's clock, simulated time or not.
core::Nanoseconds WallNow();
/// The vector in the unit of the message.
Eigen::Vector3d ToVector(const geometry_msgs::Vector3& vector);

/// \throws std::invalid_argument where the sample period is not in [0.0001, 1] s or a force is not finite or above 2e6
/// N.
core::Episode FromMessage(const Episode& message);
/// The message of an episode.
Episode ToMessage(const core::Episode& episode);
/// The message of an edge.
EpisodeEvent ToMessage(const core::EpisodeEdge& edge, const std::string& frame_id);

/// The message of a tare [N] that was measured at `time`.
Tare TareMessage(const Eigen::Vector3d& force, core::Nanoseconds time, const std::string& frame_id);

/// \throws std::invalid_argument where the message has another format version or its contents have faults, naming them.
core::Model FromMessage(const ShapeletModel& message);
/// The message of a model, stamped with the time of its training.
ShapeletModel ToMessage(const core::Model& model);

/// The features of an episode by a model.
ShapeletFeatures FeaturesMessage(const core::Episode& episode, const core::Model& model,
                                 const core::ShapeletDistances& features);
/// The diagnosis of an episode by a model; `final` is false while the episode is open.
Diagnosis DiagnosisMessage(const core::Episode& episode, const core::Model& model, const core::Diagnosis& diagnosis,
                           bool final);

}  // namespace contact_shapelets
