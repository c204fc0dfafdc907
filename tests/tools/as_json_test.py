"""tests/conformance/as_json.py: what it makes of a small file, and of all SINUMERIK files."""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent / "conformance"
SMALL = """; SOURCE a manual
; CASE a signal
; SIGNAL X12.5
; SET R5 = 2.5
MEAS=1 G1 X50 F300
M30
; EXPECT MOVES 1
; EXPECT MOVE 1 G31 X12.5 F300
; EXPECT R1 = 1 WITHIN 0.5
; EXPECT OUTPUT "A\\n"

; CASE an alarm
R1=
; EXPECT ALARM 12080 AT 1

; CASE a sheet has no place there
; SHEET [tools.1]
; EXPECT COMPLETED
"""


def converted(*files):
    done = subprocess.run([sys.executable, "-B", HERE / "as_json.py", *files], capture_output=True, check=True)
    return json.loads(done.stdout), done.stderr.decode()


def main():
    with tempfile.TemporaryDirectory() as folder:
        small = pathlib.Path(folder) / "small.mpf"
        small.write_text(SMALL, encoding="utf-8")
        cases, summary = converted(small)
    assert summary == "2 cases, 1 left out\n", summary
    assert cases[0] == {
        "id": "small-001", "dialect": "sinumerik", "point": "a signal", "source": "a manual",
        "program": "\n\nMEAS=1 G1 X50 F300\nM30\n\n\n\n\n\n",
        "setup": {"skips": [{"axis": "X", "at": 12.5}], "vars": {"R5": 2.5}},
        "expect": {"alarm": None, "tol": 0.5, "vars": {"R1": 1.0}, "output": "A\n",
                   "moves": [{"g": 31, "X": 12.5}]},
        "confidence": "medium"}, cases[0]
    assert cases[1]["expect"] == {"alarm": 12080}, cases[1]

    cases, _ = converted(*sorted((HERE / "sinumerik").glob("*.mpf")))
    ids = [case["id"] for case in cases]
    assert len(ids) == len(set(ids)), "ids repeat"
    assert all(case["source"] for case in cases), [case["id"] for case in cases if not case["source"]]
    assert len(cases) >= 250, len(cases)
    return 0


if __name__ == "__main__":
    sys.exit(main())
