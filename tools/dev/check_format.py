#!/usr/bin/env python3
"""Fails when a C++ file is not as clang-format 14 of Debian 12 writes it with the tree's .clang-format.

Without clang-format of that version nothing is checked, and the exit code is 77: other versions write other
text.  Usage: check_format.py REPOSITORY
"""
import pathlib
import re
import subprocess
import sys

from source_tree import files_of, report

SKIPPED = 77
VERSION = "14."
PLACE = re.compile(r"^(.+?):(\d+):\d+: error: ", re.MULTILINE)


def formatter_version():
    """What clang-format says of itself; empty where there is none."""
    try:
        done = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return ""
    found = re.search(r"version (\S+)", done.stdout)
    return found.group(1) if found else ""


def main():
    root = pathlib.Path(sys.argv[1])
    version = formatter_version()
    if not version.startswith(VERSION):
        print(f"skipped: clang-format {VERSION}x is not here (found: {version or 'none'})")
        return SKIPPED
    files = [file.relative_to(root).as_posix() for file in files_of(root, ".h", ".cc")]
    command = ["clang-format", "--dry-run", "-Werror", *files]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    problems = sorted({(file, int(line), "clang-format writes it otherwise") for file, line in PLACE.findall(done.stderr)})
    if done.returncode != 0 and not problems:
        print(done.stderr)
        return 1
    return report(problems, f"format: {len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
