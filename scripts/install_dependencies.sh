#!/usr/bin/env bash
# Installs what the package needs: on Debian with ROS 1 from Debian's own packages, on Ubuntu 20.04 beside ROS Noetic. With --tests
# it also installs what the tests alone use. It installs optional packages if the archive has them.
set -euo pipefail

optional=(libbenchmark-dev libmujoco-dev)
[ "${1:-}" != --tests ] || optional+=(catkin-lint doxygen python3-numpy)

common=(build-essential cmake pkg-config libeigen3-dev libfftw3-dev libboost-program-options-dev libconsole-bridge-dev libgtest-dev
  libyaml-cpp-dev liborocos-kdl-dev)

if [ -d /opt/ros/noetic ]; then
  packages=("${common[@]}" ros-noetic-roscpp ros-noetic-rosbag ros-noetic-rosbag-storage ros-noetic-rostest
    ros-noetic-roslaunch ros-noetic-rosbash ros-noetic-rostopic ros-noetic-rosservice ros-noetic-actionlib ros-noetic-actionlib-msgs
    ros-noetic-diagnostic-msgs ros-noetic-diagnostic-updater ros-noetic-geometry-msgs ros-noetic-kdl-parser ros-noetic-std-msgs
    ros-noetic-std-srvs ros-noetic-roslib ros-noetic-topic-tools ros-noetic-message-generation
    ros-noetic-message-runtime)
elif grep -q '^VERSION_CODENAME=focal' /etc/os-release; then
  echo "/opt/ros/noetic: expected ROS Noetic on Ubuntu 20.04, found none: install ros-noetic-ros-base first" >&2
  exit 1
else
  packages=("${common[@]}" catkin ros-message-generation ros-message-runtime libroscpp-dev librosbag-dev
    librosbag-storage-dev libroslib-dev librosconsole-dev librostest-dev libtopic-tools-dev libactionlib-dev
    libdiagnostic-updater-dev libdiagnostic-msgs-dev libactionlib-msgs-dev ros-actionlib-msgs ros-diagnostic-msgs
    libgeometry-msgs-dev ros-geometry-msgs libstd-msgs-dev ros-std-msgs libstd-srvs-dev ros-std-srvs
    libkdl-parser-dev libros-rosgraph-msgs-dev python3-actionlib python3-rosbag python3-roslaunch python3-rosmaster
    python3-rosmsg python3-rosnode python3-rosparam python3-rospy python3-rosservice python3-rostest python3-rostopic python3-rosunit
    python3-topic-tools python3-diagnostic-msgs python3-geometry-msgs python3-std-msgs python3-std-srvs
    python3-catkin-pkg python3-empy rosbash rosout rospack-tools)
fi

is_installed() {
  dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed
}

in_archive() {
  apt-cache show "$1" >/dev/null 2>&1
}

missing=()
for package in "${packages[@]}"; do is_installed "$package" || missing+=("$package"); done
# On a new system the lists of the archive are empty: what it has is known after the update.
wanted=()
for package in "${optional[@]}"; do
  if ! is_installed "$package" && { [ ${#missing[@]} -gt 0 ] || in_archive "$package"; }; then wanted+=("$package"); fi
done
[ $((${#missing[@]} + ${#wanted[@]})) -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
for package in "${wanted[@]}"; do
  if in_archive "$package"; then missing+=("$package"); else echo "The archive has no $package, which is optional" >&2; fi
done
echo "Installing: ${missing[*]}" >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
