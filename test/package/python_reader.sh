#!/usr/bin/env bash
# Tests the Python module on the shipped bags. Counts as skipped without NumPy.
set -euo pipefail

test=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/python/reader_test.py
/usr/bin/python3 -c 'import numpy' 2>/dev/null || { echo "NumPy is not there"; exit 77; }
/usr/bin/python3 "$test"
