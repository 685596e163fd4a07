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
/// Conversions between messages and the core's types.

namespace contact_shapelets {

/// Returns nanoseconds since the epoch.
core::Nanoseconds ToNanoseconds(const ros::Time& time);
/// Returns the time of `nanoseconds` since the epoch; zero if they are negative.
ros::Time ToTime(core::Nanoseconds nanoseconds);
/// Returns the time of the machine's clock, even under simulated time.
core::Nanoseconds WallNow();
/// Returns the vector in the unit of the message.
Eigen::Vector3d ToVector(const geometry_msgs::Vector3& vector);

/// Returns the episode of a message. \throws std::invalid_argument if the sample period is not in [0.0001, 1] s, or a
/// force is not finite or above 2e6 N.
core::Episode FromMessage(const Episode& message);
/// Returns the message of an episode.
Episode ToMessage(const core::Episode& episode);
/// Returns the message of an edge.
EpisodeEvent ToMessage(const core::EpisodeEdge& edge, const std::string& frame_id);

/// Returns the message of a tare [N] that was measured at `time`.
Tare TareMessage(const Eigen::Vector3d& force, core::Nanoseconds time, const std::string& frame_id);

/// Returns the model of a message. \throws std::invalid_argument naming all faults if the message has another format
/// version or an invalid model.
core::Model FromMessage(const ShapeletModel& message);
/// Returns the message of a model, stamped with the time of its training.
ShapeletModel ToMessage(const core::Model& model);

/// Returns the message of an episode's features.
ShapeletFeatures FeaturesMessage(const core::Episode& episode, const core::Model& model,
                                 const core::ShapeletDistances& features);
/// Returns the message of an episode's diagnosis; `final` is false while the episode is open.
Diagnosis DiagnosisMessage(const core::Episode& episode, const core::Model& model, const core::Diagnosis& diagnosis,
                           bool final);

}  // namespace contact_shapelets
