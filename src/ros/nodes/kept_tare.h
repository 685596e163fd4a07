#pragma once

#include <ros/node_handle.h>

#include <Eigen/Core>
#include <optional>

#include "contact_shapelets/core/time.h"

/// \file
/// Keeps the tare on the parameter server, in `~tare_offset`, for the node that takes the place of one that died.

namespace contact_shapelets {

/// Private parameter that holds the tare.
inline constexpr char kTareParameter[] = "tare_offset";

/// A measured tare.
struct KeptTare {
  Eigen::Vector3d force;        ///< [N]
  core::Nanoseconds stamp = 0;  ///< stamp of the last wrench in the mean
};

/// Sets the parameter in the namespace of `private_node_handle`: force, stamp, time of the system clock and launch.
void KeepTare(const ros::NodeHandle& private_node_handle, const KeptTare& tare);

/// Returns the tare that an earlier node of this launch kept, and logs its age. Returns nothing if there is none, if it
/// is from another launch, or if it is no tare; logs the last two. A launch is the process that starts the nodes: all
/// launches of one master have the same /run_id.
std::optional<KeptTare> FindKeptTare(const ros::NodeHandle& private_node_handle);

}  // namespace contact_shapelets
