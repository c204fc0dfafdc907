#!/usr/bin/env python3
"""Times the two dialects of g31 on the same work, alternating, and prints processor times and their
ratio.

    sinumerik_beside_fanuc.py build/release/tools/cli/g31        all workloads, 5 rounds
    sinumerik_beside_fanuc.py G31 --scale 0.1 --only loop-r      quicker

Use a release build on a quiet machine: the median of the rounds counts.
"""
import argparse
import pathlib
import statistics
import tempfile

import sinumerik_workloads
from beside_rs274 import measure


def command(g31, control, programs):
    return [g31.resolve(), "run", *programs, "--control", control, "--max-blocks", "10000000000",
            "--max-time", "86400"]


def compare(arguments, workload, folder):
    """One row: the medians of the alternating rounds, and the median of the rounds' ratios."""
    count = max(1, int(workload.size * arguments.scale))
    commands, folders = [], []
    for control, write in (("fanuc-30i", workload.fanuc), ("sinumerik-828d", workload.sinumerik)):
        folders.append(folder / workload.name / control)
        folders[-1].mkdir(parents=True)
        commands.append(command(arguments.g31, control, write(folders[-1], count)))
    rounds = [[measure(*job) for job in zip(commands, folders)] for _ in range(arguments.rounds)]
    fanuc, sinumerik = zip(*rounds)
    seconds = [statistics.median(run.seconds for run in runs) for runs in (fanuc, sinumerik)]
    peaks = [max(run.peak_mib for run in runs) for runs in (fanuc, sinumerik)]
    ratio = statistics.median(theirs.seconds / ours.seconds for ours, theirs in rounds)
    print(f"{workload.name:12} {count:>9} {seconds[0]:9.3f} {peaks[0]:8.1f} {seconds[1]:11.3f} "
          f"{peaks[1]:8.1f} {ratio:6.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("g31", type=pathlib.Path, help="the program, of a release build")
    parser.add_argument("--scale", type=float, default=1.0, help="size of the workloads (default 1)")
    parser.add_argument("--rounds", type=int, default=5, help="runs of each dialect (default 5)")
    parser.add_argument("--only", action="append", metavar="NAME", help="this workload; repeatable",
                        choices=[workload.name for workload in sinumerik_workloads.WORKLOADS])
    parser.add_argument("--folder", type=pathlib.Path, help="where temporary folders are made")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="g31_bench_", dir=arguments.folder) as name:
        print(f"{'workload':12} {'size':>9} {'fanuc s':>9} {'MiB':>8} {'sinumerik s':>11} {'MiB':>8} "
              f"{'ratio':>6}")
        for workload in sinumerik_workloads.WORKLOADS:
            if not arguments.only or workload.name in arguments.only:
                compare(arguments, workload, pathlib.Path(name))


if __name__ == "__main__":
    main()
