#include "ros/nodes/standby.h"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/time.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cstdint>
#include <string>

namespace contact_shapelets {
namespace {

/// [s] Longest wait for the answer of a busy node.
constexpr double kPatience = 5.0;
constexpr double kBetweenLooks = 0.5;
constexpr double kBetweenSteps = 0.01;

/// Returns the address of the node of this name by the master; an empty string if the master knows none.
std::string RegisteredUri() {
  XmlRpc::XmlRpcValue question;
  question[0] = ros::this_node::getName();
  question[1] = ros::this_node::getName();
  XmlRpc::XmlRpcValue answer;
  XmlRpc::XmlRpcValue uri;
  const bool found = ros::master::execute("lookupNode", question, answer, uri, false);
  if (!found || uri.getType() != XmlRpc::XmlRpcValue::TypeString) return "";
  return static_cast<std::string&>(uri);
}

/// Returns true if a node answers at the address. The master also knows nodes that crashed.
bool Answers(const std::string& uri) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return false;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue question;
  question[0] = ros::this_node::getName();
  XmlRpc::XmlRpcValue answer;
  bool done = false;
  if (client.executeNonBlock("getPid", question)) {
    const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(kPatience);
    while (!done && client.getfd() >= 0 && ros::SteadyTime::now() < end) {
      client._disp.work(kBetweenSteps);
      done = client.executeCheckDone(answer);
      if (!done) ros::WallDuration(kBetweenSteps).sleep();
    }
  }
  if (!done && client.getfd() >= 0) {
    ROS_WARN(
        "%s at %s has not answered for %.0f s: it hangs or is suspended. This node takes its place, so ROS ends it",
        ros::this_node::getName().c_str(), uri.c_str(), kPatience);
  }
  client.close();
  // A connection that was refused is done as well.
  return done && answer.getType() == XmlRpc::XmlRpcValue::TypeArray;
}

}  // namespace

void WaitForName() {
  bool said = false;
  for (std::string uri = RegisteredUri(); !uri.empty() && Answers(uri); uri = RegisteredUri()) {
    if (!said) {
      ROS_WARN("%s runs already at %s. This node takes over when that one ends", ros::this_node::getName().c_str(),
               uri.c_str());
      said = true;
    }
    ros::WallDuration(kBetweenLooks).sleep();
  }
  if (said) ROS_WARN("%s takes over", ros::this_node::getName().c_str());
}

}  // namespace contact_shapelets
