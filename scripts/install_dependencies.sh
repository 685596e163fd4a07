#!/usr/bin/env bash
# Installs what the package needs: ROS 1 from Debian 12's own packages, or the rest beside ROS Noetic on Ubuntu 20.04.
set -euo pipefail

common=(build-essential cmake pkg-config libeigen3-dev libfftw3-dev libboost-program-options-dev libconsole-bridge-dev libgtest-dev
  libyaml-cpp-dev libbenchmark-dev liborocos-kdl-dev
  python3-numpy)

if [ -d /opt/ros/noetic ]; then
  packages=("${common[@]}" ros-noetic-roscpp ros-noetic-rosbag ros-noetic-rosbag-storage ros-noetic-rostest
    ros-noetic-roslaunch ros-noetic-rosbash ros-noetic-rostopic ros-noetic-rosservice ros-noetic-actionlib ros-noetic-actionlib-msgs
    ros-noetic-diagnostic-msgs ros-noetic-diagnostic-updater ros-noetic-geometry-msgs ros-noetic-kdl-parser ros-noetic-std-msgs
    ros-noetic-std-srvs ros-noetic-roslib ros-noetic-topic-tools ros-noetic-message-generation
    ros-noetic-message-runtime)
elif grep -q '^VERSION_CODENAME=focal' /etc/os-release; then
  echo "/opt/ros/noetic: expected ROS Noetic, which Ubuntu 20.04 needs, but found none; install ros-noetic-ros-base first" >&2
  exit 1
else
  packages=("${common[@]}" catkin ros-message-generation ros-message-runtime libroscpp-dev librosbag-dev
    librosbag-storage-dev libroslib-dev librosconsole-dev librostest-dev libtopic-tools-dev libactionlib-dev
    libdiagnostic-updater-dev libdiagnostic-msgs-dev libactionlib-msgs-dev ros-actionlib-msgs ros-diagnostic-msgs
    libgeometry-msgs-dev ros-geometry-msgs libstd-msgs-dev ros-std-msgs libstd-srvs-dev ros-std-srvs
    libkdl-parser-dev libros-rosgraph-msgs-dev python3-actionlib python3-rosbag python3-roslaunch python3-rosmaster
    python3-rosmsg python3-rosnode python3-rosparam python3-rospy python3-rosservice python3-rostest python3-rostopic python3-rosunit
    python3-topic-tools python3-diagnostic-msgs python3-geometry-msgs python3-std-msgs python3-std-srvs
    python3-catkin-pkg python3-empy rosbash rosout rospack-tools libmujoco-dev catkin-lint)
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing: ${missing[*]}" >&2
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
