#!/usr/bin/env bash
# Builds the package in a workspace of its own and prints the path of that workspace's setup file.
# The workspace is under ~/.cache unless CONTACT_SHAPELETS_WORKSPACE names another folder. It gathers compiler warnings in warnings.log.
set -euo pipefail

package=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
digest=$(printf '%s' "$package" | cksum | cut -d' ' -f1)
workspace=${CONTACT_SHAPELETS_WORKSPACE:-${XDG_CACHE_HOME:-$HOME/.cache}/contact_shapelets/$digest}

# catkin needs the system's Python.
export PATH=/usr/bin:$PATH
if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u
  . /opt/ros/noetic/setup.bash
  set -u
fi

mkdir -p "$workspace/src"
ln -sfn "$package" "$workspace/src/contact_shapelets"
cd "$workspace"
# The same arguments for every script: other ones would configure the workspace anew.
if ! catkin_make -j"$(nproc)" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCATKIN_ENABLE_TESTING=ON "$@" \
  >"$workspace/build.log" 2>&1; then
  { grep -E 'error|Error|not found' -A5 "$workspace/build.log" | head -60 >&2; } || true
  echo "The build failed; its whole output is in $workspace/build.log" >&2
  exit 1
fi
# make shows a warning only while it compiles.
grep -F ' warning: ' "$workspace/build.log" >>"$workspace/warnings.log" || true
echo "$workspace/devel/setup.bash"
