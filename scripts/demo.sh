#!/usr/bin/env bash
# From nothing to a live diagnosis: installs what is missing, builds, trains on the recorded bags, lets the simulated cell push
# (or replays recorded pushes), prints one line per push, and writes a report. Stops every process that it started. Exits with 0 if
# every diagnosis is right.
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bags=$(dirname "$scripts")/bags
"$scripts/install_dependencies.sh"
echo "Building (the first time takes some minutes)" >&2
setup=$("$scripts/build.sh") || { echo "The build ended with exit code $?, see above" >&2; exit 1; }
output=$(dirname "$(dirname "$setup")")/demo
mkdir -p "$output"

export PATH=/usr/bin:$PATH
set +u
. "$setup"
set -u

echo "Training on $bags/switch_push_train.bag"
rosrun contact_shapelets shapelets train "$bags/switch_push_train.bag" --clusters 3 --model "$output/model.bag"
echo
echo "Test on pushes that the training has not seen"
rosrun contact_shapelets shapelets classify "$bags/switch_push_test.bag" --model "$output/model.bag" \
  --csv "$output/test.csv" | tail -n 1
rosrun contact_shapelets shapelets report "$output/model.bag" "$bags/switch_push_test.bag" --out "$output/report" >/dev/null

# A new roscore on a free port does not disturb one that is running already.
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_LOG_DIR=$output/log
unset ROS_HOSTNAME
started=()
stop_all() {
  for ((index = ${#started[@]} - 1; index >= 0; --index)); do
    kill -INT "${started[index]}" 2>/dev/null || true
    wait "${started[index]}" 2>/dev/null || true
  done
}
trap stop_all EXIT

# Without a process group of its own, which job control gives it, a background process ignores an interrupt.
set -m
roscore -p "$port" >"$output/roscore.log" 2>&1 &
started+=($!)
for ((attempt = 1; ; ++attempt)); do
  answer=$(timeout 10 rosparam list 2>&1) && break
  if ! kill -0 "${started[0]}" 2>/dev/null || [ "$attempt" -ge 150 ]; then
    { tail "$output/roscore.log"; echo "roscore does not answer at $ROS_MASTER_URI: $answer"; } >&2
    exit 1
  fi
  sleep 0.1
done

# The watch must start before the first push.
rosrun contact_shapelets watch_diagnoses.py --episodes 12 --timeout 120 --unknown slipped_off collision missing &
watch=$!
started+=("$watch")
echo
if [ -x "$(dirname "$setup")/lib/contact_shapelets/simulated_cell_node" ]; then
  echo "Pushing in the simulated cell at four times its speed"
  echo "The model was not trained on slipped_off, collision and missing: unknown is right for them"
  cell=true
else
  echo "Replaying $bags/switch_push_raw.bag at four times its speed (no MuJoCo: no simulated cell)"
  cell=false
fi
roslaunch contact_shapelets demo.launch cell:="$cell" model:="$output/model.bag" speed:=4 \
  topics:="/episode_active /episode_event /outcome" >"$output/demo.log" 2>&1 &
started+=($!)

# The watch ends last, unless roscore or roslaunch died.
wait -n || true
if kill -0 "$watch" 2>/dev/null; then
  { tail -n 20 "$output/demo.log"; echo "roslaunch or roscore ended before the pushes did; logs are in $output"; } >&2
  exit 1
fi
status=0
wait "$watch" || status=$?
[ "$status" -ne 2 ] || tail -n 20 "$output/demo.log" >&2

echo "Model, report, table (test.csv) and logs are in $output"
exit "$status"
