"""Keeps the documents that Python tests have g31 write, as tests/support/kept_documents does those of the others.

documents_of_tests_test.py holds them all against their schemas.  They go to the folder that the environment variable
G31_KEPT_DOCUMENTS names; without it nothing is kept.
"""
import hashlib
import os
import pathlib
import re
import subprocess

MOST_BYTES = 4_000_000
BEGINNING = re.compile(rb'"schema": ?"g31\.')


def keep(text):
    """A text that g31 wrote; what has no document in it is left alone, and what is larger than 4 MB."""
    text = text.encode() if isinstance(text, str) else text or b""
    schema = BEGINNING.search(text)
    begin = text.rfind(b"{", 0, schema.start()) if schema else -1
    folder = os.environ.get("G31_KEPT_DOCUMENTS")
    if begin < 0 or len(text) > MOST_BYTES or not folder:
        return
    file = pathlib.Path(folder) / f"{hashlib.sha256(text).hexdigest()[:16]}.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_suffix(f".{os.getpid()}")
    part.write_bytes(text[begin:])
    part.replace(file)


def keep_folder(folder):
    """All documents in a folder and those below it."""
    for ending in ("json", "jsonl"):
        for file in pathlib.Path(folder).rglob(f"*.{ending}"):
            keep(file.read_bytes())


def run(words, cwd, **keywords):
    """subprocess.run of a g31, with what it writes kept: standard output, and the files of --json and --jsonl."""
    done = subprocess.run(words, cwd=cwd, check=False, **keywords)
    keep(done.stdout)
    for option, value in zip(words, words[1:]):
        file = pathlib.Path(cwd) / value
        # Where it was refused as a place for a document, it is what it was before.
        if option in ("--json", "--jsonl") and file.is_file() and file.suffix in (".json", ".jsonl"):
            keep(file.read_bytes())
        if words[1:2] == ["plan"] and option == "-o" and (file / "plan.json").is_file():
            keep((file / "plan.json").read_bytes())
    return done
