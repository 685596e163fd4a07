#!/usr/bin/env bash
# Fails if the compiler warned in any build of a workspace since the last test. Usage: compiler_warnings.sh WORKSPACE
set -euo pipefail

warnings=$1/warnings.log
[ -s "$warnings" ] || exit 0
sort -u "$warnings"
echo "compiler warnings: $(sort -u "$warnings" | wc -l)"
# make shows a warning only while it compiles: the next build compiles all anew, or the next test would pass.
cmake --build "$1/build" --target clean
rm "$warnings"
exit 1
