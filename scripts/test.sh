#!/usr/bin/env bash
# Installs what is missing, builds, runs every gtest and rostest, and prints the counts. Exits with another status than 0 after any
# failure.
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
# Tests run one at a time, because a second test would slow the nodes of a rostest down beyond its limits.
cmake --build build -- -j1 -k run_tests >test.log 2>&1 || status=1

# Ubuntu's ROS does not include catkin_lint.
if command -v catkin_lint >/dev/null; then
  catkin_lint "$(dirname "$scripts")" || status=1
else
  echo "catkin_lint is not installed and did not check package.xml and CMakeLists.txt" >&2
fi
/usr/bin/python3 "$scripts/count_tests.py" build/test_results || status=1
exit $status
