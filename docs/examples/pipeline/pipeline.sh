#!/bin/sh
# What a pipeline does with the programs of a folder: pipeline.sh FOLDER
# It stays where it was called, so that findings name files as the repository does.
# Exit code 0: every program is clean and comes to what its sheet expects.
set -eu
format=text
if [ -n "${GITHUB_ACTIONS:-}" ]; then
  format=github
fi
# fanuc-0i for O numbers; .MPF and .SPF speak for themselves.
if ls "$1"/*.MPF >/dev/null 2>&1; then
  g31 check "$1" --format "$format"
  g31 run "$1/CALIBRATE.MPF" -s "$1/machine.toml"
  g31 run "$1/MEASURE.MPF" -s "$1/machine.toml" -s "$1/flange.toml" --json "$1/measure.json"
else
  g31 check "$1" --control fanuc-0i --format "$format"
  for control in 0i 30i; do
    g31 run "$1/calibrate.nc" -s "$1/machine.toml" -s "$1/$control.toml"
    g31 run "$1/inspect.nc" -s "$1/machine.toml" -s "$1/$control.toml" -s "$1/flange.toml" --json "$1/inspect-$control.json"
  done
fi
