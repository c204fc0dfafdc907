#!/usr/bin/env python3
"""Every document that a test had g31 write, against docs/schema.  Usage: documents_of_tests_test.py FOLDER

tests/support/kept_documents keeps them in FOLDER while tests run; here they are read and taken away.
"""
import collections
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Schemas:
    """The schemas of docs, each read once."""

    def __init__(self, jsonschema):
        self.jsonschema = jsonschema
        self.known = {}

    def of(self, name):
        """A validator; None where docs have no schema of that name."""
        if name not in self.known:
            path = ROOT / f"docs/schema/{name}.schema.json"
            schema = json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
            self.known[name] = schema and self.jsonschema.Draft7Validator(schema)
        return self.known[name]


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


def main():
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed: documents are not tried")
        return 77
    schemas, seen, wrong = Schemas(jsonschema), collections.Counter(), []
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.json"))
    for file in files:
        text = file.read_text(encoding="utf-8")
        try:
            for name, document in documents_in(text):
                seen[name] += 1
                validator = schemas.of(name)
                if validator is None:
                    wrong.append(f"{name}: docs/schema has nothing of it: {text[:200]}")
                    continue
                fields = validator.schema.get("properties", {})
                if name != "g31.events":
                    wrong += [f"{name}: the schema has no {field}" for field in document if field not in fields]
                wrong += [f"{name}: {error.json_path}: {error.message[:300]}" for error in validator.iter_errors(document)]
        except ValueError as error:
            wrong.append(f"no JSON: {error}: {text[:200]}")
        file.unlink()
    if not files:
        print("no test has written a document before")
        return 77
    print("\n".join([*sorted(set(wrong)), *(f"{name}: {count}" for name, count in sorted(seen.items()))]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
