#!/usr/bin/env python3
"""Time and memory of a run that touches a large binary STL: reading it and building its trees.

Usage: stl_load.py G31 [BANDS]

Writes a sphere of about 4 BANDS^2 triangles (1119: 5,004,168; 500: 998,000), touches it once from above and
prints processor time and peak memory beside what is wanted, and wall time.  Fails where the touch is not
where the sphere is, where g31 finds anything wrong with the mesh, or where five million triangles take more
than 8 s of processor time or 1.5 GB.
"""
import math
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import time

# Of so many triangles; less is judged in proportion, down to a tenth: the program itself takes some memory.
JUDGED_TRIANGLES = 5e6
MOST_SECONDS = 8.0
MOST_MEGABYTES = 1536.0
RADIUS = 20.0

SHEET = """[probe]
ball_diameter = 6.0
length = 120.0
[machine]
stopping = "ideal"
[[part]]
file = "sphere.stl"
[start]
Z = 300.0
"""
PROGRAM = "O1\nG91 G31 Z-170. F1000\nM30\n"


def write_sphere(path, bands):
    """Rows of vertices from pole to pole, two triangles a square.  Returns the number of triangles."""
    around = 2 * bands
    rows = []
    for i in range(bands + 1):
        polar = math.pi * i / bands
        across = RADIUS * math.sin(polar) if 0 < i < bands else 0.0
        rows.append([(across * math.cos(math.pi * j / bands), across * math.sin(math.pi * j / bands),
                      RADIUS * math.cos(polar)) for j in range(around)])
    facet = struct.Struct("<12fH").pack
    body = bytearray()
    for i in range(bands):
        for j in range(around):
            k = (j + 1) % around
            if i + 1 < bands:
                body += facet(0, 0, 0, *rows[i][j], *rows[i + 1][j], *rows[i + 1][k], 0)
            if i > 0:
                body += facet(0, 0, 0, *rows[i][j], *rows[i + 1][k], *rows[i][k], 0)
    count = len(body) // 50
    path.write_bytes(bytes(80) + struct.pack("<I", count) + body)
    return count


def main():
    g31 = pathlib.Path(sys.argv[1]).resolve()
    bands = int(sys.argv[2]) if len(sys.argv) > 2 else 1119
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        count = write_sphere(folder / "sphere.stl", bands)
        (folder / "setup.toml").write_text(SHEET)
        (folder / "touch.nc").write_text(PROGRAM)
        begin = time.monotonic()
        run = subprocess.run([g31, "run", "touch.nc", "-s", "setup.toml", "--print", "#5063"],
                             cwd=folder, capture_output=True, text=True, check=True)
        wall = time.monotonic() - begin
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = used.ru_utime + used.ru_stime
    megabytes = used.ru_maxrss / 1024
    touch = float(run.stdout.split("=")[1])
    share = max(count / JUDGED_TRIANGLES, 0.1)
    print(f"{count} triangles: {seconds:.1f} s of processor time (wanted {MOST_SECONDS * share:.1f}), "
          f"{megabytes:.0f} MB at most (wanted {MOST_MEGABYTES * share:.0f}), {wall:.1f} s on the clock; "
          f"touch at Z{touch:.6f}")
    # Ball centre 3 mm over the pole, the spindle 120 mm above that.
    right = abs(touch - (RADIUS + 3.0 + 120.0)) < 1e-4
    light = seconds <= MOST_SECONDS * share and megabytes <= MOST_MEGABYTES * share
    if not right:
        print("the touch is not on the sphere", file=sys.stderr)
    if not light:
        print("more than wanted", file=sys.stderr)
    return 0 if right and light else 1


if __name__ == "__main__":
    sys.exit(main())
