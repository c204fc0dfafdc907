#!/usr/bin/env python3
"""The figures of speed beside each other: interpreter, contacts, moves of the whole probe, one calibration.

    figures.py build/release                     everything
    figures.py build/release --scale 0.1 --rounds 3   quicker, and less exact

Blocks, arcs, calls and loops are set beside LinuxCNC's rs274 (beside_rs274.py), contacts and moves come
from g31_bench, and the processor time of O6001 on its ring gauge from runs of g31.  Use a release build
with Google Benchmark on a quiet machine, and compare ratios within one run only: the fastest round
counts.
"""
import argparse
import dataclasses
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import beside_rs274
import workloads

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOVE = "whole_probe_move/past"
NEAR_MISS = "whole_probe_near_miss"
CALIBRATION = "macros/fanuc/O6001.nc"
RING = "parts/library/ring_gauge/ring.toml"


@dataclasses.dataclass(frozen=True)
class Figure:
    name: str
    case: str            # of g31_bench
    unit: str
    wanted: float | None
    is_most: bool        # whether more than wanted is too much, or too little


FIGURES = [
    Figure("contacts, smooth mesh of 998,000", "sphere/500", "1/s", None, False),
    Figure("contacts, rough mesh of 998,000", "dented_sphere/500", "1/s", 300e3, False),
    Figure("move past a part of 80", f"{MOVE}/5", "us", 2.0, True),
    Figure("move past a part of 9,800", f"{MOVE}/50", "us", 20.0, True),
    Figure("move past a part of 998,000", f"{MOVE}/500", "us", 60.0, True),
    Figure("oblique near miss, 9,800", f"{NEAR_MISS}/50", "us", 20.0, True),
    Figure("oblique near miss, 998,000", f"{NEAR_MISS}/500", "us", 60.0, True),
]


def print_row(name, value, unit, wanted, is_most):
    row = f"{name:34} {value:12.1f} {unit:>4}"
    if wanted is not None:
        reached = value <= wanted if is_most else value >= wanted
        row += f" {wanted:12.1f} {'reached' if reached else 'missed'}"
    print(row, flush=True)


def benchmark_rows(bench, rounds):
    """Rows of g31_bench, the fastest round of each."""
    names = "|".join(f"^{figure.case}$" for figure in FIGURES)
    run = subprocess.run([bench, f"--benchmark_filter={names}", "--benchmark_format=json",
                          f"--benchmark_repetitions={rounds}"],
                         capture_output=True, text=True, check=True)
    rounds_of = {}
    for case in json.loads(run.stdout)["benchmarks"]:
        if case["run_type"] == "iteration":
            rounds_of.setdefault(case["run_name"], []).append(case)
    for figure in FIGURES:
        if figure.case not in rounds_of:
            sys.exit(f"{bench} has no case {figure.case}")
        cases = rounds_of[figure.case]
        if figure.unit == "us":
            to_us = {"ns": 1e-3, "us": 1.0, "ms": 1e3}
            value = min(case["cpu_time"] * to_us[case["time_unit"]] for case in cases)
        else:
            value = max(case["items_per_second"] for case in cases)
        print_row(figure.name, value, figure.unit, figure.wanted, figure.is_most)


def calibration_row(g31, rounds, folder):
    """Processor time of a calibration on the ring: a run is so short that many are looked at."""
    command = [g31, "run", ROOT / CALIBRATION, "--setup", ROOT / RING]
    runs = [beside_rs274.measure(command, folder) for _ in range(10 * rounds)]
    print_row("O6001 on its ring, processor time", 1e3 * beside_rs274.best(runs).seconds, "ms", 20.0,
              True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="folder of a release build")
    parser.add_argument("--scale", type=float, default=1.0,
                        help="size of the interpreter's workloads (default 1)")
    parser.add_argument("--rounds", type=int, default=5, help="runs of each (default 5)")
    parser.add_argument("--rs274", default=shutil.which("rs274"), help="LinuxCNC's interpreter")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    arguments.g31 = build / "tools/cli/g31"
    print(f"{'figure':34} {'measured':>12} {'':4} {'wanted':>12}")
    with tempfile.TemporaryDirectory(prefix="g31_bench_") as name:
        folder = pathlib.Path(name)
        calibration_row(arguments.g31, arguments.rounds, folder)
        benchmark_rows(build / "tests/g31_bench", arguments.rounds)
        print()
        arguments.g31 = beside_rs274.copied(arguments.g31, folder)
        beside_rs274.compare_all(arguments, workloads.WORKLOADS, folder)


if __name__ == "__main__":
    main()
