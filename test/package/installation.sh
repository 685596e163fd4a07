#!/usr/bin/env bash
# Installs a build, and uses the installed package as another package would. Usage: installation.sh WORKSPACE
set -euo pipefail

tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
workspace=$1
install=$workspace/install
share=$install/share/contact_shapelets
build=$workspace/installation_test
rm -rf "$install" "$build"
cmake --install "$workspace/build" >/dev/null

# Nothing of the devel space may help, and another Python in front of the system's has no catkin.
export PATH=/usr/bin:$PATH
unset CMAKE_PREFIX_PATH LD_LIBRARY_PATH PKG_CONFIG_PATH PYTHONPATH ROS_PACKAGE_PATH
set +u
# shellcheck source=/dev/null
. "$install/setup.bash"
set -u

configure_and_build() {  # SOURCE BUILD
  cmake -S "$1" -B "$2" -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3
  cmake --build "$2"
}

configure_and_build "$tests/package/public_headers" "$build/public_headers"
configure_and_build "$tests/downstream" "$build/downstream"

"$build/downstream/devel/lib/contact_shapelets_downstream/downstream" "$share/bags/switch_push_train.bag" \
  "$share/bags/switch_push_test.bag" >"$build/events"
counts=$(awk '$1 == $2 {++right} END {print right + 0, "of", NR}' "$build/events")
if [ "$counts" != "45 of 45" ]; then
  echo "expected the outcome as the event of 45 of 45 pushes, but found $counts"
  exit 1
fi

# Every page that an installed file refers to.
status=0
while read -r page; do
  [ -f "$share/$page" ] || { echo "$share/$page: installed files refer to it, but it is not installed"; status=1; }
done < <(grep -rhoE 'docs/[a-z_]+\.(md|png)' --include='*.md' --include='*.yaml' --include='*.launch' "$share" | sort -u)
exit "$status"
