#!/usr/bin/env python3
"""Fails when a file or folder has a name that says nothing, or one in another spelling than the rest.

Usage: check_names.py REPOSITORY
"""
import pathlib
import re
import sys

from source_tree import files_of, report

# Whatever fits nowhere else ends up in files of these names.
SAY_NOTHING = {"common", "helper", "helpers", "manager", "misc", "shared", "stuff", "util", "utilities", "utils"}
SPELLING = re.compile(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*")


def problems_of(here):
    """Problems of one path."""
    for part in pathlib.PurePosixPath(here).with_suffix("").parts:
        if SAY_NOTHING & set(part.lower().split("_")):
            yield here, 1, f"{part} says nothing about what is in it"
        elif not SPELLING.fullmatch(part):
            yield here, 1, f"{part}: names are lower case, words joined by _"


def main():
    root = pathlib.Path(sys.argv[1])
    files = files_of(root, ".h", ".cc", ".def", ".py")
    problems = [problem for file in files for problem in problems_of(file.relative_to(root).as_posix())]
    return report(problems, f"names: {len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
