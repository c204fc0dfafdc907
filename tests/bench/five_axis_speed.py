#!/usr/bin/env python3
"""Processor time of five axes beside that of three.

    five_axis_speed.py build/release/tools/cli/g31            everything
    five_axis_speed.py G31 --scale 0.1 --rounds 3             quicker, and less exact

Blocks of G1 under TRAORI (SINUMERIK) and G43.4 (Fanuc) on a tilted table beside the same blocks without, the
rotary axes standing at an angle: twice the time is allowed.  CYCLE9960 measures two axes at 12 positions each:
0.3 s of processor time are allowed.  Runs alternate and the fastest of each counts; use a release build.
"""
import argparse
import pathlib
import tempfile

from beside_rs274 import best, measure

BLOCKS = 1_000_000
MOST_RATIO = 2.0
MOST_CYCLE_S = 0.3

TABLES = """[machine]
table_side = "CA"
tool_side = "XYZ"
[machine.axes.X]
travel = [-3000.0, 3000.0]
[machine.axes.Y]
travel = [-3000.0, 3000.0]
[machine.axes.Z]
travel = [-3000.0, 3000.0]
[machine.axes.A]
travel = [-120.0, 120.0]
centre = [0.0, 20.0, -450.0]
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [5.0, -3.0, 0.0]
[work_offsets.G54]
X = 150.0
Y = -40.0
Z = -400.0
"""
PROBE = """[control]
profile = "sinumerik-828d"
[tools.1]
length = 120.0
radius = 3.0
type = 710.0
name = "PROBE"
[probe]
ball_diameter = 6.0
length = 117.0
[variables]
"$SNS_MEA_WP_BALL_DIAM[0]" = 6.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]" = -3.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]" = -3.0
[[part]]
name = "ball"
shape = "sphere"
on = "G54"
at = [0.1, -0.2, 0.05]
diameter = 25.0
"""
CYCLE = """T1 M6
G54 D1
$SCS_MEA_KIN_MIN_ANG_TRIANGLE=10
G0 X0 Y0 Z50
Z15.5
CYCLE9960(10400,"",1,25,0,-60,60,12,0,0,0,300,12,0,1,3,5,1,1,0,0)
M30
"""


def points(count):
    """Places of a spiral with three decimals."""
    for i in range(count):
        yield (i * 7 % 400) / 10 - 20, (i * 11 % 300) / 10 - 15, (i % 97) / 10


def sinumerik(count, leads):
    yield "T1 D1 M6\nG54 G64\nA30 C40\n" + ("TRAORI\n" if leads else "") + "G1 F5000\n"
    for x, y, z in points(count):
        yield f"X{x:.3f} Y{y:.3f} Z{z:.3f}\n"
    yield "M30\n"


def fanuc(count, leads):
    yield "%\nO1\nG54 G90 G0 A30. C40.\n" + ("G43.4 H1\n" if leads else "G43 H1\n") + "G1 F5000.\n"
    for x, y, z in points(count):
        yield f"X{x:.3f} Y{y:.3f} Z{z:.3f}\n"
    yield "M30\n%\n"


def seconds(arguments, folder, program, sheets):
    command = [arguments.g31.resolve(), "run", program]
    for sheet in sheets:
        command += ["-s", sheet]
    return measure(command + ["--max-blocks", "10000000000", "--max-time", "86400"], folder)


def print_row(name, value, unit, wanted):
    print(f"{name:44} {value:10.3f} {unit:5} {wanted:8.3f} {'reached' if value <= wanted else 'missed'}", flush=True)


def compare(arguments, folder, name, write, ending, profile):
    count = max(1, int(BLOCKS * arguments.scale))
    sheet = folder / f"{name}.toml"
    sheet.write_text(f'[control]\nprofile = "{profile}"\n[tools.1]\nlength = 120.0\n' + TABLES, encoding="utf-8")
    runs = {False: [], True: []}
    for leads in runs:
        with open(folder / f"{name}_{leads}.{ending}", "w", encoding="utf-8") as program:
            program.writelines(write(count, leads))
    for _ in range(arguments.rounds):
        for leads, times in runs.items():
            times.append(seconds(arguments, folder, f"{name}_{leads}.{ending}", [sheet]))
    plain, led = (best(times).seconds for times in runs.values())
    print_row(f"{name}: {count} blocks, times those without", led / plain, f"{led:.2f}s", MOST_RATIO)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("g31", type=pathlib.Path, help="the program, of a release build")
    parser.add_argument("--scale", type=float, default=1.0, help="of a million blocks (default 1)")
    parser.add_argument("--rounds", type=int, default=5, help="runs of each (default 5)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="g31_bench_") as name:
        folder = pathlib.Path(name)
        compare(arguments, folder, "TRAORI", sinumerik, "mpf", "sinumerik-828d")
        compare(arguments, folder, "G43.4", fanuc, "nc", "fanuc-30i")
        (folder / "tables.toml").write_text(TABLES, encoding="utf-8")
        (folder / "probe.toml").write_text(PROBE, encoding="utf-8")
        (folder / "cycle.mpf").write_text(CYCLE, encoding="utf-8")
        runs = [seconds(arguments, folder, "cycle.mpf", ["probe.toml", "tables.toml"]) for _ in range(arguments.rounds)]
        print_row("CYCLE9960, 2 x 12 positions", best(runs).seconds, "s", MOST_CYCLE_S)


if __name__ == "__main__":
    main()
