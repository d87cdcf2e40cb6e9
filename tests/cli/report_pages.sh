#!/usr/bin/env bash
# Reads pages of `morula report` by Python's HTML parser. No text becomes markup, ids are unique, and the commands of a
# page work.
#
#   report_pages.sh MORULA RESEAL     RESEAL: the program of tests/reseal.cpp
#
# Exit codes: 0 passed, 1 failed, 77 skipped: there is no python3.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
morula=$1
export RESEAL=$2
python=/usr/bin/python3
[ -x $python ] || {
  echo "skipped: python3 is not installed"
  exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$morula" morula
export MORULA_CALLED_AS=./morula # as the start script does

cat >small.yaml <<'YAML'
morula: 1
name: small
summary: "</p><script>window.evil=1</script><img src=x onerror=alert(2)> & \"quotes\""
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
record: {every: 0.5, measures: [sister_contact]}
names:
  cells: {A: '<img/src=x/onerror=alert(4)>', B: "</script><script>'B'&amp;"}
colours: {'a*': '#e41a1c'}
YAML
cat >two.study.yaml <<'YAML'
morula-study: 1
name: two
summary: "<script>alert(6)</script>"
base: small.yaml
vary:
  drag:
    less: {physics.drag: 1}
    fails: {physics.pressure.constant: 0.5, physics.pressure.outside: 400}
seeds: 1..2
measures: [sphericity]
YAML
quiet() { # the first argument: accepted exit codes
  codes=$1
  shift
  code=0
  "$@" >>log 2>&1 || code=$?
  case ,$codes, in *,$code,*) ;; *)
    tail -n 20 log
    echo "exit $code: $*"
    exit 1
    ;;
  esac
}
quiet 0 ./morula run small.yaml --db one.db --out one --quiet --no-pictures
quiet 0,1 ./morula run small.yaml --db other.db --out other --quiet --no-pictures --set physics.drag=2 \
  --set check.sane=false --set 'check.because=<i>because</i><script>alert(5)</script>'
quiet 4 ./morula run small.yaml --db failed.db --out failed --quiet --no-pictures \
  --set physics.pressure.constant=0.5 --set physics.pressure.outside=400
quiet 1 ./morula study run two.study.yaml --out study --no-predict --quiet
CI='' quiet 0 ./morula review small.yaml --accept --by tests --why "the first one"
sed -i 's/time: 1.5/time: 1.6/' small.yaml
quiet 1 ./morula check small.yaml --reports checked --quiet
quiet 0 ./morula report one.db -o one.html --quiet --frames 2
cp checked/report.html checked.html
quiet 0 ./morula report one.db other.db failed.db study checked -o all.html --quiet --frames 2
"$python" "$here/report_pages.py" "$work" one checked all
