#!/bin/sh
# Tests the Python package: python_test.sh package|examples|shipped BUILD CONFIGURATION FOLDER PYTHON. FOLDER: of the package,
# which is built if need be; "" where CMake found no pybind11.
set -eu
part=$1 build=$2 configuration=$3 folder=$4 python=$5
here=$(cd "$(dirname "$0")" && pwd)
lack() { echo "skipped: $*" && exit 77; }
[ -n "$folder" ] || lack "there is no pybind11, or no python3-dev"
needed="numpy pandas pytest xdist"
if [ "$part" = examples ]; then needed="numpy pandas pytest scipy matplotlib"; fi
for module in $needed; do "$python" -c "import $module" 2>/dev/null || lack "$python has no $module"; done
cmake --build "$build" --config "$configuration" --target python-module >"$build/python.log" 2>&1 || { cat "$build/python.log" && exit 1; }
export PYTHONPATH="$folder" PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1
unset CI
case $part in
  package) set -- test_same_bits.py test_package.py test_stored.py test_plugin.py ;;
  examples) set -- test_examples.py ;;
  shipped) MORULA_TEST_ALL=1 && export MORULA_TEST_ALL && set -- test_same_bits.py -k shipped ;;
esac
cd "$here"
exec "$python" -m pytest -q -p no:cacheprovider "$@"
