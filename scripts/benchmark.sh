#!/usr/bin/env bash
# Measures the kernel, the training and the offline program, and prints one table. The two sides of a ratio are measured in turn,
# in processor time (the offline program by the clock), so that other load on the machine slows both alike.
#   scripts/benchmark.sh [--json FILE] [--filter REGEX]
set -euo pipefail

package=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
json=
filter=.
while [ $# -gt 0 ]; do
  case $1 in
    --json) json=${2:?--json needs a file}; shift 2 ;;
    --filter) filter=${2:?--filter needs a regular expression}; shift 2 ;;
    *) echo "usage: $0 [--json FILE] [--filter REGEX]" >&2; exit 2 ;;
  esac
done

setup=$("$package/scripts/build.sh")
workspace=$(dirname "$(dirname "$setup")")
programs=$workspace/devel/lib/contact_shapelets
export PATH=/usr/bin:$PATH CONTACT_SHAPELETS_BAGS=$package/bags
set +u
. "$setup"
set -u
if ! cmake --build "$workspace/build" --target shapelets_benchmark >"$workspace/benchmark_build.log" 2>&1; then
  echo "The benchmark was not built (it needs libbenchmark-dev): see $workspace/benchmark_build.log" >&2
  exit 1
fi
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
"$programs/shapelets_benchmark" --benchmark_filter="$filter" --benchmark_out="$results/benchmark.json" \
  --benchmark_out_format=json >&2
/usr/bin/python3 "$package/scripts/benchmark_table.py" "$results/benchmark.json" --program "$programs/shapelets" \
  --bags "$package/bags" --filter "$filter" ${json:+--json "$json"}
