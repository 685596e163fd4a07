#!/usr/bin/env bash
# Measures the running nodes: latency of a diagnosis for 200 pushes at 1 kHz, load of the episode node, and whether eight
# robots at 1 kHz lose a sample in SECONDS (default 120). Usage: scripts/soak.sh [SECONDS]
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
seconds=${1:-120}
setup=$("$scripts/build.sh")
export PATH=/usr/bin:$PATH
set +u
. "$setup"
set -u
programs=$(dirname "$setup")/lib/contact_shapelets
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1
unset ROS_HOSTNAME
folder=$(mktemp -d)
started=()
finish() {
  [ ${#started[@]} -eq 0 ] || kill "${started[@]}" 2>/dev/null || true
  wait
  rm -rf "$folder"
}
trap finish EXIT

start() {
  "$@" >>"$folder/log" 2>&1 &
  started+=($!)
}

# Clock ticks of the processor that a process has used.
ticks() {
  awk '{print $14 + $15}' "/proc/$1/stat"
}

"$programs/shapelets" train "$scripts/../bags/switch_push_train.bag" --model "$folder/model.bag" >/dev/null 2>&1
start roscore -p "$port"
until rosparam list >/dev/null 2>&1; do sleep 0.2; done

start env ROS_NAMESPACE=robot0 "$programs/episode_node"
episode_node=$!
start env ROS_NAMESPACE=robot0 "$programs/classifier_node" _model:="$folder/model.bag"
before=$(ticks "$episode_node")
begin=$(date +%s%N)
echo "One robot, 200 pushes:"
"$programs/live_load" --robots 1 --seconds 121
end=$(date +%s%N)
awk -v ticks=$(($(ticks "$episode_node") - before)) -v hertz="$(getconf CLK_TCK)" -v time=$((end - begin)) \
  'BEGIN { printf "episode_node: %.1f %% of one core\n", 100 * ticks / hertz / (time * 1e-9) }'

for robot in 1 2 3 4 5 6 7; do
  start env ROS_NAMESPACE="robot$robot" "$programs/episode_node"
  start env ROS_NAMESPACE="robot$robot" "$programs/classifier_node" _model:="$folder/model.bag"
done
# The first robot's counts start anew, too.
kill "$episode_node"
start env ROS_NAMESPACE=robot0 "$programs/episode_node"
echo "Eight robots, $seconds s:"
"$programs/live_load" --robots 8 --seconds "$seconds"
