#!/usr/bin/env python3
"""Every document that a test had g31 write, against docs/schema.  Usage: documents_of_tests_test.py FOLDER

tests/support/kept_documents keeps them in FOLDER while tests run; here they are read and taken away.
"""
import collections
import functools
import importlib.util
import json
import multiprocessing
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


@functools.cache
def validator_of(name):
    """Of a schema in docs, read once a process; None where docs have none of that name."""
    import jsonschema
    path = ROOT / f"docs/schema/{name}.schema.json"
    return jsonschema.Draft7Validator(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else None


def documents_in(text):
    """(name of the schema, document) of each: one, or the lines of a log."""
    text = text.lstrip()
    first, end = json.JSONDecoder().raw_decode(text)
    name = str(first.get("schema", "")).split("/", maxsplit=1)[0].replace("study.shard", "study")
    if name != "g31.events":
        yield name, first
        return
    # What is printed behind a log is no line of it; a log that a test broke off has a line that does not end.
    for line in text.splitlines():
        if line.startswith('{"event"') and line.endswith("}"):
            yield name, json.loads(line)


def shape_of(value):
    """Equal for values that a schema takes alike: fields with their types, texts, sides of 0 and 1 that numbers lie on."""
    if isinstance(value, dict):
        return tuple((name, shape_of(field)) for name, field in value.items())
    if isinstance(value, list):
        return tuple(shape_of(one) if isinstance(one, (dict, list)) else type(one) for one in value)
    if isinstance(value, (int, float)):
        return type(value), value < 0, value < 1
    return value


def without_like_rows(value):
    """A document with one row of each shape in its lists of objects: they take long, and most are alike."""
    if isinstance(value, list):
        rows = {shape_of(row): row for row in value} if value and isinstance(value[0], dict) else {}
        return [without_like_rows(row) for row in (rows.values() if rows else value)]
    if isinstance(value, dict):
        return {name: without_like_rows(field) for name, field in value.items()}
    return value


def looked_at(file):
    """(counts of schemas, what is wrong) of one file, which is taken away."""
    seen, wrong = collections.Counter(), []
    text = file.read_text(encoding="utf-8")
    try:
        for name, document in documents_in(text):
            seen[name] += 1
            validator = validator_of(name)
            if validator is None:
                wrong.append(f"{name}: docs/schema has nothing of it: {text[:200]}")
                continue
            fields = validator.schema.get("properties", {})
            if name != "g31.events":
                wrong += [f"{name}: the schema has no {field}" for field in document if field not in fields]
            errors = validator.iter_errors(without_like_rows(document))
            wrong += [f"{name}: {error.json_path}: {error.message[:300]}" for error in errors]
    except ValueError as error:
        wrong.append(f"no JSON: {error}: {text[:200]}")
    file.unlink()
    return seen, wrong


def main():
    if importlib.util.find_spec("jsonschema") is None:
        print("python3-jsonschema is not installed: documents are not tried")
        return 77
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.json"))
    if not files:
        print("no test has written a document before")
        return 77
    seen, wrong = collections.Counter(), set()
    # All other tests have ended: every core is free for this one.
    with multiprocessing.Pool() as pool:
        for counted, found in pool.imap_unordered(looked_at, files, chunksize=8):
            seen += counted
            wrong |= set(found)
    print("\n".join([*sorted(wrong), *(f"{name}: {count}" for name, count in sorted(seen.items()))]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
