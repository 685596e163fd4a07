#!/usr/bin/env bash
# Fails if catkin_lint finds a fault in a package.xml or CMakeLists.txt.
set -euo pipefail

if ! command -v catkin_lint >/dev/null; then
  echo "catkin_lint is not installed"
  exit 77
fi
package=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
catkin_lint "$package" "$package/test/downstream"
