#include "ros/nodes/kept_tare.h"

#include <ros/console.h>
#include <ros/network.h>
#include <ros/time.h>
#include <unistd.h>

#include <map>
#include <string>

#include "contact_shapelets/core/episode.h"

namespace contact_shapelets {
namespace {

std::string ThisLaunch() { return ros::network::getHost() + ":" + std::to_string(getppid()); }

}  // namespace

void KeepTare(const ros::NodeHandle& private_node_handle, const KeptTare& tare) {
  XmlRpc::XmlRpcValue value;
  value["x"] = tare.force.x();
  value["y"] = tare.force.y();
  value["z"] = tare.force.z();
  // The parameter server has no integer of 64 bits.
  value["stamp"] = std::to_string(tare.stamp);
  value["time"] = ros::WallTime::now().toSec();
  value["launch"] = ThisLaunch();
  private_node_handle.setParam(kTareParameter, value);
}

std::optional<KeptTare> FindKeptTare(const ros::NodeHandle& private_node_handle) {
  if (!private_node_handle.hasParam(kTareParameter)) return std::nullopt;
  const ros::NodeHandle kept(private_node_handle, kTareParameter);
  KeptTare tare;
  std::string stamp;
  std::string launch;
  double time = 0.0;
  const bool whole = kept.getParam("x", tare.force.x()) && kept.getParam("y", tare.force.y()) &&
                     kept.getParam("z", tare.force.z()) && kept.getParam("stamp", stamp) &&
                     kept.getParam("time", time) && kept.getParam("launch", launch);
  if (!whole || launch != ThisLaunch() || !(tare.force.norm() <= core::kGreatestForce)) {
    ROS_WARN("Ignoring ~%s: it is not from this launch. Call ~tare in free air", kTareParameter);
    return std::nullopt;
  }
  tare.stamp = std::strtoll(stamp.c_str(), nullptr, 10);
  ROS_INFO("Using the tare that was measured %.1f min ago", (ros::WallTime::now().toSec() - time) / 60.0);
  return tare;
}

}  // namespace contact_shapelets
