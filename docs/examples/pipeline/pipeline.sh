#!/bin/sh
# What a pipeline does with the programs of this folder: pipeline.sh FOLDER
# Exit code 0: every program is clean and comes to what its sheet expects.
set -eu
cd "$1"
format=text
if [ -n "${GITHUB_ACTIONS:-}" ]; then
  format=github
fi
# fanuc-0i for O numbers; .MPF and .SPF speak for themselves.
if ls ./*.MPF >/dev/null 2>&1; then
  g31 check . --format "$format"
  g31 run CALIBRATE.MPF -s machine.toml
  g31 run MEASURE.MPF -s machine.toml -s flange.toml --json measure.json
else
  g31 check . --control fanuc-0i --format "$format"
  for control in 0i 30i; do
    g31 run calibrate.nc -s machine.toml -s "$control.toml"
    g31 run inspect.nc -s machine.toml -s "$control.toml" -s flange.toml --json "inspect-$control.json"
  done
fi
