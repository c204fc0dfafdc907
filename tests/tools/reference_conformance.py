#!/usr/bin/env python3
"""Runs the reference cases of the Fanuc language, which are no part of this repository.

Usage: reference_conformance.py G31

The environment variable G31_CONFORMANCE names their folder; it holds fanuc.json and run.py, which
takes `--g31 PROGRAM CASES.json` and exits with 0 when every case passes.  Without the variable
nothing runs and the exit code is 77, which ctest counts as skipped.

The moves that a case expects count in the unit of its program, those of a result document in mm (the
contract of the command line): the figures of cases in G20 are multiplied by 25.4 before they run.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
VARIABLE = "G31_CONFORMANCE"
MM_PER_INCH = 25.4
LENGTHS = ("X", "Y", "Z")


def in_millimetres(cases):
    """The cases, the expected moves of those that switch to inches and never back in mm."""
    for case in cases:
        program = case["program"]
        if re.search(r"G20(?!\d)", program) and not re.search(r"G21(?!\d)", program):
            for move in case["expect"].get("moves", []):
                move.update({axis: move[axis] * MM_PER_INCH for axis in LENGTHS if axis in move})
    return cases


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
    command = [sys.executable, "-B", str(runner), "--g31", sys.argv[1], "--min-confidence", "medium"]
    with tempfile.TemporaryDirectory() as scratch:
        metric = pathlib.Path(scratch) / cases.name
        read = json.loads(cases.read_text(encoding="utf-8"))
        metric.write_text(json.dumps(in_millimetres(read)), encoding="utf-8")
        return subprocess.run(command + [str(metric)], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
