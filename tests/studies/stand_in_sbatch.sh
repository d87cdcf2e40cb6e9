#!/usr/bin/env bash
# Stands in for sbatch: runs the jobs of a job array here, one after the other.
#
#   stand_in_sbatch.sh SCRIPT
#
# Exit codes: 0 all jobs succeeded, 1 a job failed.
set -euo pipefail
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
output=$(sed -n 's/^#SBATCH --output=//p' "$1")
code=0
for ((job = ${range%-*}; job <= ${range#*-}; ++job)); do
  log=${output//%A/1}
  SLURM_ARRAY_TASK_ID=$job SLURM_CPUS_PER_TASK=1 bash "$1" >"${log//%a/$job}" 2>&1 || code=1
done
exit $code
