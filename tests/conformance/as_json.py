#!/usr/bin/env python3
"""Writes conformance files as JSON, for other interpreters and their runners.

usage: as_json.py FILE.mpf... > cases.json

One object a case: id, dialect, point, program, setup, expect, confidence, source.  What JSON of this form
cannot say (lines of a set-up sheet, messages, warnings) leaves its case out; standard error tells how many.
The form of the files themselves is described in tests/support/conformance_file.h.
"""
import json
import pathlib
import re
import sys

MOVE = re.compile(r"MOVE (\d+) G(\d+)(.*)")
WORD = re.compile(r"([XYZABCTF])(-?[\d.]+(?:e-?\d+)?)")
VARIABLE = re.compile(r"(\S+) = (.+)")


class NotInJson(Exception):
    """The case says something that has no place in the JSON."""


def comment_of(line):
    if line.startswith("; "):
        return line[2:]
    return line[1:-1] if line.startswith("(") and line.endswith(")") else ""


def number(text):
    return None if text == "VACANT" else json.loads(text) if text.startswith('"') else float(text)


def expect_variable(expect, text):
    name, value = VARIABLE.fullmatch(text).groups()
    value, _, tolerance = value.partition(" WITHIN ")
    if tolerance:
        expect["tol"] = max(expect.get("tol", 0.0), float(tolerance))
    expect.setdefault("vars", {})[name] = number(value)


def unescaped(text):
    return json.loads(re.sub(r"\\x([0-9A-Fa-f]{2})", r"\\u00\1", text))


def take_expectation(expect, text):
    word, _, rest = text.partition(" ")
    move = MOVE.fullmatch(text)
    if word == "COMPLETED":
        return
    if word == "ALARM" and rest.split()[0].isdigit():
        expect["alarm"] = int(rest.split()[0])
    elif word == "OUTPUT":
        expect["output"] = unescaped(rest)
    elif word == "STOP":
        expect["stop"] = unescaped(rest)
    elif word == "MOVES":
        expect["count"] = int(rest)
    elif move:
        words = {letter.lower() if letter == "T" else letter: float(value)
                 for letter, value in WORD.findall(move[3]) if letter != "F"}
        expect.setdefault("known", {})[int(move[1])] = {"g": int(move[2]), **words}
    elif VARIABLE.fullmatch(text) and word not in ("NO", "WARNING", "MESSAGE"):
        expect_variable(expect, text)
    else:
        raise NotInJson(text)


def moves_of(expect):
    """Moves count as a whole: those of a case that names only some of them are left out."""
    known, count = expect.pop("known", {}), expect.pop("count", None)
    if count is not None and len(known) == count:
        expect["moves"] = [known[i + 1] for i in range(count)]


def take_setup(setup, word, rest):
    name, _, value = rest.partition(" = ")
    if word in ("PARAMETER", "SET", "START"):
        key = {"PARAMETER": "params", "SET": "vars", "START": "position"}[word]
        setup.setdefault(key, {})[name] = float(value) if key != "params" else json.loads(value)
    elif word == "SIGNAL":
        signal = {} if rest == "NONE" else {"axis": rest[0], "at": float(rest[1:])}
        setup.setdefault("skips", []).append(signal)
    elif word == "SETTING" and name == "block_skip":
        setup["block_skip"] = json.loads(value)
    else:
        raise NotInJson(f"{word} {rest}")


def case_of(path, index, title, lines, source):
    case = {"id": f"{path.stem}-{index:03}", "dialect": "sinumerik" if path.suffix == ".mpf" else "fanuc",
            "point": title, "program": "", "setup": {}, "expect": {"alarm": None}, "confidence": "medium",
            "source": source}
    for line in lines:
        word, _, rest = comment_of(line).partition(" ")
        if word == "EXPECT":
            take_expectation(case["expect"], rest)
        elif word in ("PARAMETER", "SET", "START", "SIGNAL", "SETTING", "SHEET"):
            take_setup(case["setup"], word, rest)
        elif word not in ("SOURCE", "CONTROL"):
            case["program"] += line + "\n"
            continue
        case["program"] += "\n"
    moves_of(case["expect"])
    if case["expect"] == {"alarm": None} and "COMPLETED" not in "\n".join(lines):
        raise NotInJson("some moves only")
    return case


def cases_of(path):
    """@returns the cases, and how many have no place in the JSON"""
    cases, left_out, source, title, lines = [], 0, "", None, []
    text = path.read_text(encoding="utf-8").split("\n")
    for line in [*text, "; CASE"]:
        word, _, rest = (comment_of(line) or line[2:] if line == "; CASE" else comment_of(line)).partition(" ")
        if word == "CASE":
            if title is not None:
                try:
                    cases.append(case_of(path, len(cases) + left_out + 1, title, lines, source))
                except NotInJson:
                    left_out += 1
            title, lines = rest, []
        elif word == "SOURCE":
            source = rest
        else:
            lines.append(line)
    return cases, left_out


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) > 1 else 2
    cases, left_out = [], 0
    for name in sys.argv[1:]:
        more, missing = cases_of(pathlib.Path(name))
        cases += more
        left_out += missing
    json.dump(cases, sys.stdout, indent=1, ensure_ascii=False)
    print()
    print(f"{len(cases)} cases, {left_out} left out", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
