#!/usr/bin/env python3
"""Fails when a file names a place that exists on one computer only, such as a home folder.

Usage: check_paths.py REPOSITORY
"""
import pathlib
import re
import sys

from source_tree import files_of, report

# A path begins where no name, dot, variable or address runs on into it: not ../home/x, $HOME/x.
PLACE = re.compile(
    r"(?<![\w.~})/-])/(?:home|root|Users|work|workspace|tmp|opt|mnt|srv|media)/[\w.-]"
    r"|\b[A-Za-z]:\\\\?(?:Users|Documents|Temp|home|work)\b",
)


def places(here, text):
    for number, line in enumerate(text.splitlines(), 1):
        match = PLACE.search(line)
        if match:
            yield here, number, f"a path of one computer: {line[match.start():match.start() + 40]}"


def main():
    root = pathlib.Path(sys.argv[1])
    problems = []
    files = files_of(root, "")
    for file in files:
        content = file.read_bytes()
        if b"\0" not in content:  # meshes and images have no paths to read
            problems += places(file.relative_to(root).as_posix(), content.decode(errors="replace"))
    return report(problems, f"paths: {len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
