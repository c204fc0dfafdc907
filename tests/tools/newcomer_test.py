"""Mistakes that newcomers make, each with what g31 says to do about it.  Usage: newcomer_test.py G31"""
import pathlib
import sys
import tempfile

import kept_documents

PROGRAM = "O1\nG90 G54\nG31 X40. F100.\n#500=#5061\nM30\n"
SHEET = """[start]
Z = 300.0
[work_offsets.G54]
X = 0.0
[probe]
length = 100.0
[[part]]
name = "wall"
shape = "block"
at = [80.0, 0.0, 210.0]
"""
CAD = "[[part]]\nfile = \"part.{}\"\n"
SINUMERIK = "G90 G54\nMEAS=1 G1 X40 F100\nSTOPRE\nR1=$AA_MW[X]\nIF R1>50 GOTOF OUT\nOUT: M30\n"


def run(*words):
    """A run of p.nc with s.toml and further words."""
    return ("run", "p.nc", "-s", "s.toml", *words)


# What is done, its files beside p.nc and s.toml, its command, its exit code, what is said about it.
MISTAKES = (
    ("a mistyped command", {}, ("rum", "p.nc"), 2, "there is no command rum, did you mean run?"),
    ("a command that is none", {}, ("simulate", "p.nc"), 2, "there is no command simulate; there are run, "),
    ("a mistyped option", {}, ("run", "p.nc", "--steup", "s.toml"), 2, "run has no option --steup, did you mean --setup?"),
    ("a mistyped control", {}, run("--control", "hass"), 5, "did you mean 'haas'?"),
    ("a control that is unknown", {}, run("--control", "heidenhain"), 5, "known: fanuc-16i, "),
    ("a program that is not there", {}, ("run", "q.nc"), 2, "cannot read the program q.nc"),
    ("a sheet that is not there", {}, ("run", "p.nc", "-s", "t.toml"), 2, "cannot read the file"),
    ("a mistyped section", {"s.toml": "[prob]\n"}, run(), 2, "did you mean probe?"),
    ("a mistyped key", {"s.toml": "[probe]\nball_diamter = 6.0\n"}, run(), 2, "did you mean ball_diameter?"),
    ("a number in quotes", {"s.toml": "[probe]\nlength = \"120\"\n"}, run(), 2, "for example: length = 120.0"),
    ("a decimal comma", {"s.toml": "[probe]\nlength = 120,0\n"}, run(), 2, "s.toml:2:13: error: this is not TOML"),
    ("a variable without quotes", {"s.toml": SHEET + "[variables]\n#500 = 3.0\n"}, run(), 1, 'in quotes, "#500" = 3.0'),
    ("a shape that is none", {"s.toml": "[[part]]\nshape = \"cube\"\n"}, run(), 2, '"block" or "gauge_block"'),
    ("a size of another shape", {"s.toml": "[[part]]\nshape = \"block\"\nbore = 5.0\n"}, run(), 2, "which takes name, file"),
    ("a part without a body", {"s.toml": "[[part]]\nname = \"a\"\n"}, run(), 2, "for example: file = "),
    ("a file that is not there", {"s.toml": CAD.format("stl")}, run(), 5, "paths start at the folder of the sheet"),
    ("a mistyped machine", {"s.toml": "[machine]\nfile = \"v5.toml\"\n"}, run(), 5, "lathe_c.toml, v55.toml"),
    ("a name of another control's variable", {"p.mpf": "M30\n"}, ("run", "p.mpf", "--print", "#500"), 2, "called R1, _OVR[4] or $AA_MW[X]"),
    ("a part as IGES", {"s.toml": CAD.format("igs"), "part.igs": "S"}, run(), 5, "a file of IGES, which g31 does not read: export STEP or STL"),
    ("a part as Parasolid", {"s.toml": CAD.format("x_t"), "part.x_t": "**"}, run(), 5, "a file of Parasolid, which g31 does not read: export STEP or STL"),
    ("a part of an unknown format", {"s.toml": CAD.format("xyz"), "part.xyz": "1 2 3\n"}, run(), 5, "export STEP or STL"),
    ("a part on an offset that is not given", {"s.toml": "[[part]]\nshape = \"block\"\non = \"G55\"\n"}, run(), 2, "[work_offsets.G55]"),
    ("a part that is not where the program measures", {}, run(), 1, "the nearest part, 'wall', was 7.000 mm from the ball"),
    ("a ball that begins inside of a part", {"s.toml": SHEET.replace("80.0, 0.0", "0.0, 0.0")}, run(), None, "correct [start], where the part is"),
    ("a subprogram that is missing", {"p.nc": "O1\nG65 P9999\nM30\n"}, run(), 3, "9999"),
    ("a variable of another control", {"s.toml": "[variables]\nR1 = 2\n"}, run(), None, "R1"),
    ("a text of a SINUMERIK in a .nc file", {"p.nc": SINUMERIK}, run("--json", "-"), None, '"control": "sinumerik-828d"'),
    ("an unknown word", {}, ("explain", "ball_diamter"), 2, "did you mean 'ball_diameter'?"),
    ("an alarm that is none", {}, ("explain", "alarm 54321"), 2, "nothing is known about 'alarm 54321'"),
    ("no command", {}, (), 2, "--help"),
    ("help behind a word", {}, ("help", "run"), 0, "Examples:"),
    ("help alone", {}, ("help",), 0, "explain"),
    ("a folder that is there", {"setup.toml": "mine"}, ("new", "."), 2, "is there already: nothing is changed"),
)


def answered(g31, mistake):
    """Nothing where the mistake is answered, else why not."""
    what, files, words, code, text = mistake
    with tempfile.TemporaryDirectory() as folder:
        for name, content in {"p.nc": PROGRAM, "s.toml": SHEET, **files}.items():
            (pathlib.Path(folder) / name).write_text(content, encoding="utf-8")
        done = kept_documents.run([g31, *words], folder, capture_output=True, text=True)
    said = done.stdout + done.stderr
    if text not in said or (code is not None and done.returncode != code):
        return [f"{what}: exit {done.returncode}, expected {code} and {text!r} in:\n{said[:600]}"]
    return []


def main():
    g31 = str(pathlib.Path(sys.argv[1]).resolve())
    wrong = [problem for mistake in MISTAKES for problem in answered(g31, mistake)]
    print("\n".join([*wrong, f"{len(MISTAKES)} mistakes, {len(wrong)} without an answer"]))
    return 1 if wrong or len(MISTAKES) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
