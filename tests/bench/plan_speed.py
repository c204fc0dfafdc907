#!/usr/bin/env python3
"""Processor time of g31 plan beside that of a run that needs no STEP file.

Usage: plan_speed.py G31 WRITE_POCKETED_BLOCK STEP_MODULE

Plans the inspection example and a block of 100 features (cmake --build DIR --target write_pocketed_block), and runs a
program of one block, which no model may slow down: prints seconds, what is wanted, and how many such runs each takes.
The run of one block is measured with the module that reads STEP (build/.../modules/g31_step.so) and without it, in
turns; for the latter the file has another name as long as each lasts.
"""
import contextlib
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRODUCT = ROOT / "parts/library/inspection/product.step"
STARTS = 100


def seconds_of(command, folder):
    """Processor time of a command that ends well."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


@contextlib.contextmanager
def hidden(file):
    """The file has another name."""
    aside = file.with_name(file.name + ".aside")
    file.rename(aside)
    try:
        yield
    finally:
        aside.rename(file)


def seconds_of_starts(g31, module, folder):
    """Of a run of one block, the mean: with the module, without it."""
    seconds = [0.0, 0.0]
    for _ in range(STARTS):
        seconds[0] += seconds_of([g31, "run", "p.nc"], folder) / STARTS
        with hidden(module):
            seconds[1] += seconds_of([g31, "run", "p.nc"], folder) / STARTS
    return seconds


def main():
    g31, writer = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:3])
    module = pathlib.Path(sys.argv[3]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "p.nc").write_text("O1\nM30\n", encoding="utf-8")
        subprocess.run([writer, "10", "10", "block.step"], cwd=folder, check=True)
        start, without = seconds_of_starts(g31, module, folder)
        rows = [("a run of one block", start, 0.010), ("without the STEP module", without, 0.010)]
        for name, product, wanted in (("the inspection example", str(PRODUCT), 2.0), ("100 features", "block.step", 20.0)):
            rows.append((name, seconds_of([g31, "plan", product, "--stock", "box", "-o", "out"], folder), wanted))
    for name, seconds, wanted in rows:
        print(f"{name:<24} {seconds:8.3f} s   wanted {wanted:6.3f} s   {seconds / start:8.1f} starts")


if __name__ == "__main__":
    main()
