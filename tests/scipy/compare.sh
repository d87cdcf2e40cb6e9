#!/usr/bin/env bash
# Compares results of runner/studies/statistics with those of SciPy for the same numbers.
#
#   compare.sh PROGRAM      (statistics_numbers)
#
# Exit codes: 0 equal to 1e-9, 1 different, 77 there is no SciPy.
set -euo pipefail
python=/usr/bin/python3
if ! "$python" -c 'import scipy.stats' 2>/dev/null; then
  echo "skipped: no SciPy here (Debian: python3-scipy)"
  exit 77
fi
"$1" | "$python" "$(dirname "$(readlink -f "$0")")/compare.py"
