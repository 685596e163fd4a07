#!/usr/bin/env bash
# Installs what is missing, builds, runs every gtest and rostest, and prints the counts. Exits non-zero on any failure.
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
"$scripts/install_dependencies.sh"
setup=$("$scripts/build.sh" -DCATKIN_ENABLE_TESTING=ON)
workspace=$(dirname "$(dirname "$setup")")

export PATH=/usr/bin:$PATH
set +u
. "$setup"
set -u
cd "$workspace"
rm -rf build/test_results

status=0
cmake --build build -- -j"$(nproc)" tests >test_build.log 2>&1 || { tail -40 test_build.log >&2; exit 1; }
# One at a time: rostests start nodes that a second test would slow down beyond their limits.
cmake --build build -- -j1 -k run_tests >test.log 2>&1 || status=1

# Ubuntu's ROS does not come with it.
if command -v catkin_lint >/dev/null; then
  catkin_lint "$(dirname "$scripts")" || status=1
else
  echo "catkin_lint is not installed: package.xml and CMakeLists.txt were not checked by it" >&2
fi
/usr/bin/python3 "$scripts/count_tests.py" build/test_results || status=1
exit $status
