"""The documents of all commands against docs/schema.  Usage: document_schemas_test.py G31"""
import json
import pathlib
import re
import sys
import tempfile

import kept_documents

ROOT = pathlib.Path(__file__).resolve().parents[2]
RING = "parts/library/ring_gauge/"
STUDY = """[study]
program = "p.nc"
setup = ["s.toml"]
repeats = 3
[results.x]
value = "#500"
"""
SHEET = '[probe]\nlength = 100.0\nrepeatability_mm = 0.001\n[start]\nZ = 300.0\n[[part]]\nshape = "block"\nat = [80.0, 0.0, 210.0]\n'
FILES = {
    "p.nc": "O1\nG90 G31 X60. F100.\n#500=#5061\nG04 P100\nDPRNT[A#500[33]]\nM30\n",
    "missed.nc": "O1\nG90 G31 X20. F100.\n#500=#5061\nM30\n",
    "alarm.nc": "O1\nG65 P2\nM30\nO2\n#3000=5 (BAD)\nM99\n",
    "crash.nc": "O1\nG90 G00 X80.\nM30\n",
    "wrong.nc": "O1\nGOTO 7 (g31: disable=NC005)\n#1=[\nM30\n",
    "loop.nc": "O1\nN1 GOTO 1\nM30\n",
    "p.mpf": "MEAS=1 G1 X60 F100\nSTOPRE\nR1=$AA_MW[X]\nMSG(\"done\")\nM0\nM30\n",
    "s.toml": SHEET,
    "c.toml": SHEET + '[[characteristic]]\nname = "X"\nvariable = "#500"\nnominal = 47.0\ntolerance = 0.1\ntrue = "block.length"\n'
    '[[characteristic]]\nname = "Y"\nvariable = "#777"\n',
    "wrong.toml": "[probe]\nlength = true\n",
    "e.toml": SHEET + "[expect]\ntouches = 1\n",
    "study.toml": STUDY,
    "plan.json": '{"schema": "g31.plan/1", "measures": [{"id": "F1.X", "nominal": 40, "tolerance": [-0.1, 0.1]},'
    ' {"id": "F1.Y", "nominal": 25}]}',
    "results.txt": "F1-X 40.01200\n",
    "record.csv": "".join(["t,X,Y\n", *(f"{i * 0.01},{i * 0.1},{i * 0.1}\n" for i in range(50))]),
}
RUN = ("-s", "s.toml", "--json", "-")
COMMANDS = (
    ("run", "p.nc", *RUN, "--moves", "--touches", "--blocks", "--changes", "--print", "#500,#501"),
    ("run", "missed.nc", *RUN, "--touches"),
    ("run", "p.nc", "-s", "e.toml", "--json", "-", "--allow", "PRB316"),
    ("run", "missed.nc", *RUN, "--allow", "PRB301"),
    ("run", "wrong.nc", *RUN),
    ("run", "none.nc", *RUN),
    ("run", "alarm.nc", *RUN),
    ("run", "crash.nc", *RUN, "--moves"),
    ("run", "loop.nc", *RUN, "--max-blocks", "50"),
    ("run", "p.mpf", *RUN, "--moves", "--touches", "--blocks", "--print", "R1"),
    ("explain", "G31", "probe.length", "ring", "skip", "--json"),
    ("explain", "--all", "--json"),
    ("explain", "--all", "--json", "--control", "sinumerik-828d"),
    ("check", "p.nc", "wrong.nc", "p.mpf", "--json", "-"),
    ("check", "--rules", "--json", "-"),
    ("setup", "s.toml", "--json", "-"),
    ("setup", "s.toml", "--program", "missed.nc", "--json", "-"),
    ("study", "study.toml", "--json", "-"),
    ("study", "study.toml", "--shard", "1/2", "--json", "-"),
    ("evaluate", "diagonal", "record.csv", "--target", "5,5", "--json", "-"),
    ("judge", "plan.json", "results.txt", "--json", "-"),
    # Writes its document into a folder.
    ("plan", str(ROOT / "parts/library/inspection/product.step"), "--stock", "box", "-o", "inspection", "--as-machined",
     str(ROOT / "parts/library/inspection/product.step")),
    ("new", "beginning", "--json", "-"),
    ("--version", "--json"),
    ("run", "p.nc", "-s", "c.toml", "--json", "-"),
    ("scene", "p.nc", "-s", "s.toml", "-o", "scene.svg", "--json", "-"),
    ("scene", "crash.nc", "-s", "s.toml", "-o", "scene.svg", "--json", "-"),
    ("scene", "wrong.nc", "-o", "scene.svg", "--json", "-"),
    ("scene", "p.nc", "-s", "wrong.toml", "-o", "scene.svg", "--json", "-"),
    ("scene", "p.nc", "-o", "scene.step", "--json", "-"),
    # Refused, each by itself.
    ("setup", "wrong.toml", "--json", "-"),
    ("setup", "none.toml", "--json", "-"),
    ("new", "p.nc", "--json", "-"),
    ("view", "p.nc", "--control", "none", "--json", "-"),
    ("view", "p.nc", "--port", "65536", "--json", "-"),
    ("new", "other", "--control", "none", "--json", "-"),
    ("study", "none.toml", "--json", "-"),
    ("study", "wrong.toml", "--json", "-"),
    ("study", "--json", "-"),
    ("evaluate", "diagonal", "none.csv", "--target", "5,5", "--json", "-"),
    ("evaluate", "diagonal", "record.csv", "--target", "far", "--json", "-"),
    ("judge", "none.json", "results.txt", "--json", "-"),
    ("judge", "record.csv", "results.txt", "--json", "-"),
    ("judge", "plan.json", "none.txt", "--json", "-"),
    ("check", "p.nc", "none.nc", "--json", "-"),
    ("check", "p.nc", "--setup", "wrong.toml", "--json", "-"),
)
EVENTS = (
    ("run", "p.nc", "-s", "s.toml", "--jsonl", "-", "--print", "#500"),
    ("run", "p.mpf", "-s", "s.toml", "--jsonl", "-"),
    ("run", "crash.nc", "-s", "s.toml", "--jsonl", "-"),
    ("run", "alarm.nc", "--jsonl", "-"),
    ("run", "wrong.nc", "--jsonl", "-"),
    # Refused, some of them late.
    ("run", "none.nc", "--jsonl", "-"),
    ("run", "p.nc", "-s", "wrong.toml", "--jsonl", "-"),
    ("run", "p.nc", "--jsonl", "-", "--print", "nonsense"),
    ("run", "p.nc", "--jsonl", "-", "--expect", "#99999=1"),
)


def problems_of(g31, folder, command, jsonschema):
    """What is wrong with the document of a command."""
    done = kept_documents.run([g31, *command], folder, capture_output=True, text=True)
    # A study and a run of a program may print before their document, and behind it.
    written = pathlib.Path(folder) / "inspection/plan.json"
    text = written.read_text(encoding="utf-8") if command[0] == "plan" and written.exists() else done.stdout
    start = text.find("{")
    if start < 0:
        return [f"{' '.join(command)}: no document: {done.stderr[:300]}"]
    document, _ = json.JSONDecoder().raw_decode(text[start:])
    name = document["schema"].split("/")[0].replace("study.shard", "study")
    schema = json.loads((ROOT / f"docs/schema/{name}.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    unknown = [
        f"{' '.join(command)}: the schema has no {field}" for field in document if field not in schema["properties"]
    ]
    return unknown + [
        f"{' '.join(command)}: {error.json_path}: {error.message[:300]}"
        for error in jsonschema.Draft7Validator(schema).iter_errors(document)
    ]


def problems_of_events(g31, folder, command, jsonschema):
    """What is wrong with the lines of --jsonl."""
    done = kept_documents.run([g31, *command], folder, capture_output=True, text=True)
    schema = json.loads((ROOT / "docs/schema/g31.events.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    said = " ".join(command)
    events = [json.loads(line) for line in done.stdout.splitlines()]
    names = [event["event"] for event in events]
    wrong = []
    if names.count("start") != 1 or names.count("end") != 1 or (names[0], names[-1]) != ("start", "end"):
        wrong.append(f"{said}: one start, one end: {names}")
    known = {row["properties"]["event"]["const"]: set(row["properties"]) for row in schema["oneOf"]}
    for event in events:
        wrong += [f"{said}: {event['event']}: {error.message[:300]}" for error in jsonschema.Draft7Validator(schema).iter_errors(event)]
        wrong += [f"{said}: {event['event']}: the schema has no {name}" for name in set(event) - known[event["event"]]]
    if events[-1]["exit_code"] != done.returncode:
        wrong.append(f"{said}: exit code {events[-1]['exit_code']}, not {done.returncode}")
    return wrong


def refuses(jsonschema):
    """A schema that takes everything would say nothing."""
    wrong = []
    for path in sorted((ROOT / "docs/schema").glob("*.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        for document in ([], {"schema": "g31.other/1"}, {"schema": 5}):
            if jsonschema.Draft7Validator(schema).is_valid(document):
                wrong.append(f"{path.name} takes {document}")
    return wrong


def other_statuses():
    """Schemas whose statuses are not those of the table."""
    table = (ROOT / "tools/expect/run_statuses.def").read_text(encoding="utf-8")
    rows = re.findall(r'^RUN_STATUS\(\w+, +"(\w+)", +(true|false)\)', table, re.MULTILINE)
    wrong = [] if len(rows) > 5 else ["tools/expect/run_statuses.def: no rows"]
    for name in ("g31.run", "g31.scene"):
        schema = json.loads((ROOT / f"docs/schema/{name}.schema.json").read_text(encoding="utf-8"))
        if set(schema["properties"]["status"]["enum"]) != {status for status, _ in rows}:
            wrong.append(f"{name}: other statuses than tools/expect/run_statuses.def")
    keys = (ROOT / "tools/setup/keys.def").read_text(encoding="utf-8")
    text = next(line for line in keys.splitlines() if line.startswith("SETUP_KEY(ExpectStatus"))
    wrong += [f"keys.def: ExpectStatus does not name {status}" for status, may_be in rows if may_be == "true" and status not in text]
    return wrong


def left_out():
    """Fields of a run that the page of documents does not tell."""
    page = (ROOT / "docs/result-document.md").read_text(encoding="utf-8")
    schema = json.loads((ROOT / "docs/schema/g31.run.schema.json").read_text(encoding="utf-8"))
    return [f"docs/result-document.md: nothing of {name}" for name in schema["properties"] if f"`{name}`" not in page]


def main():
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed: schemas are not tried")
        return 77
    g31 = str(pathlib.Path(sys.argv[1]).resolve())
    wrong = refuses(jsonschema) + left_out() + other_statuses()
    with tempfile.TemporaryDirectory() as folder:
        for name, content in FILES.items():
            (pathlib.Path(folder) / name).write_text(content, encoding="utf-8")
        for command in COMMANDS:
            wrong += problems_of(g31, folder, command, jsonschema)
        for command in EVENTS:
            wrong += problems_of_events(g31, folder, command, jsonschema)
    print("\n".join([*wrong, f"{len(COMMANDS)} documents, {len(EVENTS)} logs, {len(wrong)} problems"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
