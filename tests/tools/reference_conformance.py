#!/usr/bin/env python3
"""Runs the reference cases of the Fanuc language, which are no part of this repository.

Usage: reference_conformance.py G31

The environment variable G31_CONFORMANCE names their folder; it holds fanuc.json and run.py, which
takes `--g31 PROGRAM CASES.json` and exits with 0 when every case passes.  Without the variable
nothing runs and the exit code is 77, which ctest counts as skipped.
"""
import os
import pathlib
import subprocess
import sys

SKIPPED = 77
VARIABLE = "G31_CONFORMANCE"


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    named = os.environ.get(VARIABLE)
    if not named:
        print(f"skipped: the environment variable {VARIABLE} is not set")
        return SKIPPED
    folder = pathlib.Path(named)
    runner, cases = folder / "run.py", folder / "fanuc.json"
    missing = [str(path) for path in (runner, cases) if not path.is_file()]
    if missing:
        print(f"{VARIABLE} = {named}: there is no {' and no '.join(missing)}")
        return 1
    command = [sys.executable, "-B", str(runner), "--g31", sys.argv[1]]
    return subprocess.run(command + ["--min-confidence", "medium", str(cases)], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
