#!/usr/bin/env python3
"""How long the ring study takes on one thread and on two, and that both write the same bytes.

Usage: study_threads.py G31 [REPEATS]        G31 of a Release build, on an idle machine
"""
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

STUDIES = ["ring_study", "table_3"]
ROUNDS = 3


def seconds(command):
    """Wall and processor time of the best of a few rounds."""
    best = None
    for _ in range(ROUNDS):
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        wall, after = time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best or (wall, 0.0), (wall, after.ru_utime - before.ru_utime))
    return best


def main():
    g31 = sys.argv[1]
    repeats = sys.argv[2] if len(sys.argv) > 2 else "2000"
    library = pathlib.Path(__file__).resolve().parents[2] / "parts/library/ring_gauge"
    with tempfile.TemporaryDirectory() as folder:
        for name in STUDIES:
            walls, texts = [], []
            for threads in (1, 2):
                csv = pathlib.Path(folder) / f"{name}-{threads}.csv"
                command = [g31, "study", str(library / f"{name}.toml"), "--repeats", repeats,
                           "--threads", str(threads), "--csv", str(csv)]
                wall, cpu = seconds(command)
                walls.append(wall)
                texts.append(csv.read_bytes())
                print(f"{name}, {repeats} repeats, {threads} thread(s): {wall:.2f} s ({cpu:.2f} s of processor)")
            same = "the same bytes" if texts[0] == texts[1] else "DIFFERENT BYTES"
            print(f"{name}: {walls[0] / walls[1]:.2f} times faster on two, {same}")


if __name__ == "__main__":
    main()
