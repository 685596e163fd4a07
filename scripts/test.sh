#!/usr/bin/env bash
# Installs what is missing, builds, runs every gtest, every rostest and the checks of the package as a whole, and prints the counts.
# Exits with another status than 0 after any failure.
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
checks=$(dirname "$scripts")/test/package
"$scripts/install_dependencies.sh" --tests
setup=$("$scripts/build.sh")
workspace=$(dirname "$(dirname "$setup")")

export PATH=/usr/bin:$PATH
set +u
. "$setup"
set -u
cd "$workspace"
rm -rf build/test_results

check() {  # NAME ARGUMENT...
  /usr/bin/python3 "$scripts/run_check.py" build/test_results/package "$1" "$checks/$1.sh" "${@:2}"
}

cmake --build build -- -j"$(nproc)" tests >test_build.log 2>&1 || { tail -40 test_build.log >&2; exit 1; }
grep -F ' warning: ' test_build.log >>warnings.log || true
check installation "$workspace"
check catkin_lint
check doxygen "$workspace"
check python_reader
# Tests run one at a time, because a second test would slow the nodes of a rostest down beyond its limits.
status=0
cmake --build build -- -j1 -k run_tests >test.log 2>&1 || status=1
# The last, since it cleans the build after a warning.
check compiler_warnings "$workspace"
# A test that crashed or was killed leaves no result to count.
[ $status -eq 0 ] || grep -E '^.*_run_tests_.* Error [0-9]+$' test.log >&2 || true
/usr/bin/python3 "$scripts/count_tests.py" build/test_results || status=1
exit $status
