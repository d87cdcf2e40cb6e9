#!/usr/bin/env bash
# What runner/studies/statistics says of some numbers, and what SciPy says of the same numbers.
#
#   compare.sh PROGRAM      (statistics_numbers)
#
# Exit codes: 0 the same to 1e-9, 1 not so, 77 there is no SciPy.
set -euo pipefail
python=/usr/bin/python3
if ! "$python" -c 'import scipy.stats' 2>/dev/null; then
  echo "skipped: no SciPy here (Debian: python3-scipy)"
  exit 77
fi
"$1" | "$python" "$(dirname "$(readlink -f "$0")")/compare.py"
