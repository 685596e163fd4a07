#!/usr/bin/env bash
# Fails if Doxygen warns of a comment in a public header. Usage: doxygen.sh WORKSPACE
set -euo pipefail

output=$1/doxygen
if ! command -v doxygen >/dev/null; then
  echo "Doxygen is not installed"
  exit 77
fi
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
rm -rf "$output"
mkdir -p "$output"
# It prints nothing but warnings and errors.
warnings=$({ cat Doxyfile; printf 'OUTPUT_DIRECTORY = "%s"\n' "$output"; } | doxygen - 2>&1)
if [ -n "$warnings" ]; then
  echo "$warnings"
  exit 1
fi
[ -f "$output/html/annotated.html" ] || { echo "expected pages in $output/html, but found none"; exit 1; }
