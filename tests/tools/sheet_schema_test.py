"""docs/schema/g31.sheet.schema.json against the reader: sheets that run are valid, and what one refuses the other does.

Usage: sheet_schema_test.py G31
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
PART = '[[part]]\nshape = "block"\n'
# A sheet, and whether it is right.
CASES = (
    ("", True),
    ("[probe]\nball_diameter = 6\n", True),
    ("[probe]\nball_diamter = 6.0\n", False),
    ('[probe]\nball_diameter = "6"\n', False),
    ("[probe]\nball_diameter = 0.0\n", False),
    ("[probe]\nball_diameter = 1e7\n", False),
    ("[probe]\neccentricity = [0.1]\n", False),
    ("[probe]\nready_input = 65\n", False),
    ("[probe]\nready_input = 1003\n", True),
    ("[probe]\nready_input = 3.5\n", False),
    ("[prob]\n", False),
    ("[control]\nincrement = \"IS-D\"\n", False),
    ("[control]\nincrement = \"IS-B\"\n", True),
    ("[control]\nblock_skip = [0]\n", False),
    ("[parameters]\n\"6001.8\" = 1\n", False),
    ("[parameters]\n\"6001.1\" = true\n\"1241.Z\" = -150.0\n", True),
    ("[macro_calls]\nX1 = 9010\n", False),
    ("[variables]\n\"#500\" = \"\"\n\"#501\" = 2\n", True),
    ("[variables]\n\"#500\" = \"a\"\n", False),
    ("[work_offsets.G60]\nX = 1.0\n", False),
    ("[work_offsets.\"G54.1 P3\"]\nX = 1.0\n", True),
    ("[work_offsets.G54]\nU = 1.0\n", False),
    ("[tools.a]\nlength = 1.0\n", False),
    ("[machine.axes.X]\ntravel = [0.0, 5.0]\n", True),
    ("[machine.axes.X]\ntravel = 5.0\n", False),
    ("[machine.errors]\nEXX = [[0.0, 0.0], [5.0, 0.01]]\nA0Z = 3\n", True),
    ("[machine.errors]\nEXX = [[0.0, 0.0, 1.0]]\n", False),
    ("[machine.compensation]\nEAX = 1.0\n", False),
    (PART, True),
    ("[[part]]\nname = \"nothing\"\n", False),
    (PART + "length = 10.0\n", True),
    (PART + "bore = 10.0\n", False),
    (PART + "at = [1, 2, 3]\nfixture = true\n", True),
    (PART + "at = [1, 2]\n", False),
    ("[[part]]\nshape = \"blok\"\n", False),
    ("[[tool]]\nnumber = 1\nlength = 50.0\ndiameter = 5.0\nkind = \"mill\"\n", True),
    ("[[tool]]\nnumber = 1\nlength = 50.0\ndiameter = 5.0\nkind = \"saw\"\n", False),
    ("[[tool]]\nnumber = 1\nlength = 50.0\ndiameter = 5.0\n[[tool.teeth]]\nradius = 2.5\n", True),
    ("[[tool]]\nnumber = 1\nlength = 50.0\ndiameter = 5.0\n[[tool.teeth]]\nwidth = 2.5\n", False),
    ("[tool]\nnumber = 1\n", False),
)


# Of study files and machine files, which have schemas of their own or none.
OTHER_FILES = {"study", "name", "axes", "tool_side"}
# It gives every key that there is, file and shape of one part, too.
REFUSED = "keys_4.toml"


def sheets():
    """All set-up sheets that the repository has."""
    paths = [*(ROOT / "tests/fuzz/corpus/sheets").glob("*.toml"), *(ROOT / "parts/library").glob("**/*.toml")]
    found = {path: tomllib.loads(path.read_text(encoding="utf-8")) for path in sorted(paths)}
    return {path: sheet for path, sheet in found.items() if not OTHER_FILES & sheet.keys()}


def is_read(g31, folder, text):
    """Whether g31 takes the sheet."""
    sheet = folder / "sheet.toml"
    sheet.write_text(text, encoding="utf-8")
    program = folder / "O1.nc"
    program.write_text("O1\nM30\n", encoding="utf-8")
    done = subprocess.run([g31, "run", program, "--setup", sheet], capture_output=True, check=False)
    return b"[SET" not in done.stderr


def main():
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed: schemas are not tried")
        return 77
    schema = json.loads((ROOT / "docs/schema/g31.sheet.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    wrong = []
    found = sheets()
    for path, sheet in found.items():
        errors = list(validator.iter_errors(sheet))
        if path.name == REFUSED:
            wrong += [] if len(errors) == 1 else [f"{REFUSED}: {len(errors)} errors"]
            continue
        wrong += [f"{path.relative_to(ROOT)}: {error.json_path}: {error.message[:200]}" for error in errors]
    with tempfile.TemporaryDirectory() as folder:
        for text, is_right in CASES:
            if validator.is_valid(tomllib.loads(text)) != is_right:
                wrong.append(f"the schema judges wrongly: {text!r}")
            if is_read(sys.argv[1], pathlib.Path(folder), text) != is_right:
                wrong.append(f"g31 judges otherwise: {text!r}")
    print("\n".join([*wrong, f"{len(found)} sheets, {len(CASES)} cases, {len(wrong)} problems"]))
    return 1 if wrong or len(found) < 30 else 0


if __name__ == "__main__":
    sys.exit(main())
