#!/bin/bash
# One part of a study for each task of a Slurm job array.
#   job=$(sbatch --parsable --array=1-64 slurm_array.sh STUDY.toml)
#   sbatch --dependency=afterany:$job --wrap 'g31 study --merge part-*.json --json study.json'
# The parts count from 1, so the array has to.
#SBATCH --job-name=g31-study
#SBATCH --cpus-per-task=2
#SBATCH --mem-per-cpu=1G
#SBATCH --time=01:00:00
#SBATCH --output=part-%a.log
set -euo pipefail

study=${1:?which study file}
g31 study "$study" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --threads "${SLURM_CPUS_PER_TASK:-1}" \
  --json "part-$SLURM_ARRAY_TASK_ID.json"
