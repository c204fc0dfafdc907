#!/usr/bin/env python3
"""Times g31 beside LinuxCNC's rs274 on the same work, alternating, and prints processor times and their
ratios.

    beside_rs274.py build/release/tools/cli/g31              all workloads, 5 rounds
    beside_rs274.py G31 --scale 0.1 --rounds 3 --only loop   quicker
    beside_rs274.py G31 --memory 1024                        peak memory on a program of 1024 MiB

rs274 is in Debian's linuxcnc-uspace (apt-get install --no-install-recommends linuxcnc-uspace);
without it only the times of g31 are printed.  Both programs read the file, work on it and write the
moves nowhere: rs274 prints its canonical calls to /dev/null, g31 keeps no moves without --moves.
Use a release build on a quiet machine: the fastest round counts.
"""
import argparse
import dataclasses
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import workloads


@dataclasses.dataclass(frozen=True)
class Measured:
    seconds: float
    peak_mib: float


def measure(command, folder):
    """Processor time and peak memory of one run; the program of which fails ends this one."""
    with open(folder / "errors.txt", "wb") as errors:
        child = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=errors)
        _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {child.returncode}\n"
                 + (folder / "errors.txt").read_text(errors="replace"))
    return Measured(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)


def copied(program, folder):
    """A copy, as cmake --install and packages make it: a file that the linker has just written lies in memory
    in pieces, which costs up to 15 % of the time, of one build and not of the next."""
    copy = folder / "g31"
    shutil.copy(program, copy)
    return copy


def g31_command(arguments, program):
    return [arguments.g31, "run", program, "--max-blocks", "10000000000",
            "--max-time", "86400"]


def best(runs):
    return min(runs, key=lambda run: run.seconds)


def compare(arguments, workload, folder):
    """One row: the fastest of the alternating rounds, and their ratio."""
    count = max(1, int(workload.size * arguments.scale))
    ours, theirs = folder / f"{workload.name}.nc", folder / f"{workload.name}.ngc"
    workloads.write(ours, workload.fanuc(count))
    workloads.write(theirs, workload.rs274(count))
    g31_runs, rs274_runs = [], []
    for _ in range(arguments.rounds):
        g31_runs.append(measure(g31_command(arguments, ours), folder))
        if arguments.rs274:
            rs274_runs.append(measure([arguments.rs274, "-g", "-t", "tool.tbl", theirs, "/dev/null"],
                                      folder))
    g31 = best(g31_runs)
    row = f"{workload.name:14} {count:>9} {g31.seconds:9.3f} {g31.peak_mib:8.1f}"
    if rs274_runs:
        rs274 = best(rs274_runs)
        ratio = rs274.seconds / g31.seconds
        verdict = "reached" if ratio >= workload.target else "missed"
        row += (f" {rs274.seconds:9.3f} {rs274.peak_mib:8.1f} {ratio:8.1f}"
                f" {workload.target:6.0f} {verdict}")
    print(row, flush=True)


def compare_all(arguments, chosen, folder):
    (folder / "tool.tbl").write_text("T1 P1 D0 Z0\n")
    if not arguments.rs274:
        print("no rs274 (Debian: linuxcnc-uspace): times of g31 alone")
    print(f"{'workload':14} {'size':>9} {'g31 s':>9} {'MiB':>8} {'rs274 s':>9} {'MiB':>8} "
          f"{'ratio':>8} {'target':>6}")
    for workload in chosen:
        compare(arguments, workload, folder)


def memory(arguments, folder):
    program = folder / "large.nc"
    size = workloads.write_large(program, arguments.memory * 2**20)
    run = measure(g31_command(arguments, program), folder)
    print(f"{size / 2**20:.0f} MiB of straight moves: {run.seconds:.1f} s, "
          f"{size / 2**20 / run.seconds:.1f} MiB/s, peak {run.peak_mib:.1f} MiB")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("g31", type=pathlib.Path, help="the program, of a release build")
    parser.add_argument("--scale", type=float, default=1.0, help="size of the workloads (default 1)")
    parser.add_argument("--rounds", type=int, default=5, help="runs of each program (default 5)")
    parser.add_argument("--only", action="append", metavar="NAME", help="this workload; repeatable",
                        choices=[workload.name for workload in workloads.WORKLOADS])
    parser.add_argument("--memory", type=int, metavar="MIB",
                        help="instead: peak memory on a program of this size")
    parser.add_argument("--rs274", default=shutil.which("rs274"), help="the other program")
    parser.add_argument("--folder", type=pathlib.Path, help="where temporary folders are made")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="g31_bench_", dir=arguments.folder) as name:
        folder = pathlib.Path(name)
        arguments.g31 = copied(arguments.g31, folder)
        if arguments.memory:
            memory(arguments, folder)
            return
        compare_all(arguments, [workload for workload in workloads.WORKLOADS
                                if not arguments.only or workload.name in arguments.only], folder)


if __name__ == "__main__":
    main()
