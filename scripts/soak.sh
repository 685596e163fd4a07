#!/usr/bin/env bash
# Measures the running nodes: the latency of a diagnosis over 200 pushes at 1 kHz, and the load of the episode node. Then
# eight robots at 1 kHz run for SECONDS (default 120), while their drivers' clocks drift by 100 ppm and are set by 0.4 s, and
# their drivers restart. Fails if a sample is lost or an episode is wrong. Usage: scripts/soak.sh [SECONDS]
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
seconds=${1:-120}
setup=$("$scripts/build.sh")
export PATH=/usr/bin:$PATH
set +u
. "$setup"
set -u
programs=$(dirname "$setup")/lib/contact_shapelets
workspace=$(dirname "$(dirname "$setup")")
if ! cmake --build "$workspace/build" --target live_load >"$workspace/soak_build.log" 2>&1; then
  echo "live_load was not built: see $workspace/soak_build.log" >&2
  exit 1
fi
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1
unset ROS_HOSTNAME
folder=$(mktemp -d)
started=()
finish() {
  # After a failure, the end of the nodes' log says more.
  [ $? -eq 0 ] || tail "$folder/log" >&2 || true
  for process in ${started[@]+"${started[@]}"}; do
    kill "$process" 2>/dev/null || continue
    # Kills a process that does not end within 20 s.
    for ((attempt = 1; attempt <= 200; ++attempt)); do kill -0 "$process" 2>/dev/null && sleep 0.1 || break; done
    kill -KILL "$process" 2>/dev/null || true
  done
  rm -rf "$folder"
}
trap finish EXIT

start() {
  "$@" >>"$folder/log" 2>&1 &
  started+=($!)
}

# Prints the processor time of a process in clock ticks.
ticks() {
  awk '{print $14 + $15}' "/proc/$1/stat"
}

# Drives the nodes. Fails if that takes far longer than it should.
drive() {  # ROBOTS SECONDS [OPTION]
  local limit=$(($2 + 300)) status=0
  timeout --foreground "$limit" "$programs/live_load" --robots "$1" --seconds "$2" "${@:3}" || status=$?
  [ "$status" -ne 124 ] || echo "live_load did not end within $limit s" >&2
  return "$status"
}

"$programs/shapelets" train "$scripts/../bags/switch_push_train.bag" --model "$folder/model.bag" >"$folder/log" 2>&1
: >"$folder/log"
start roscore -p "$port"
SECONDS=0
until answer=$(timeout 10 rosparam list 2>&1); do
  if ! kill -0 "${started[0]}" 2>/dev/null || [ "$SECONDS" -ge 60 ]; then
    echo "roscore does not answer at $ROS_MASTER_URI: $answer" >&2
    exit 1
  fi
  sleep 0.1
done

# Without a tare the forces of an episode are those that were sent.
start env ROS_NAMESPACE=robot0 "$programs/episode_node" _tare:=service
episode_node=$!
start env ROS_NAMESPACE=robot0 "$programs/classifier_node" _model:="$folder/model.bag"
before=$(ticks "$episode_node")
begin=$(date +%s%N)
echo "One robot, 200 pushes:"
drive 1 121
end=$(date +%s%N)
awk -v ticks=$(($(ticks "$episode_node") - before)) -v hertz="$(getconf CLK_TCK)" -v time=$((end - begin)) \
  'BEGIN { printf "episode_node: %.1f %% of one core\n", 100 * ticks / hertz / (time * 1e-9) }'

for robot in 1 2 3 4 5 6 7; do
  start env ROS_NAMESPACE="robot$robot" "$programs/episode_node" _tare:=service
  start env ROS_NAMESPACE="robot$robot" "$programs/classifier_node" _model:="$folder/model.bag"
done
# A new node for the first robot, so that its counts also start at zero.
kill "$episode_node"
start env ROS_NAMESPACE=robot0 "$programs/episode_node" _tare:=service
echo "Eight robots, $seconds s, with drift, a step and a restart of each driver:"
drive 8 "$seconds" --faults
