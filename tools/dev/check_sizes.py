#!/usr/bin/env python3
"""Fails when a source file is longer than 600 lines or a function longer than 60.

A function is found by its braces: a line that ends in `{`, is no namespace, type, control statement
or initialiser, up to the `}` in the same column (clang-format puts it there).
Usage: check_sizes.py REPOSITORY
"""
import pathlib
import re
import sys

FILE_LIMIT = 600
FUNCTION_LIMIT = 60
NOT_A_FUNCTION = re.compile(r"^\s*(namespace|class|struct|enum|union|if|for|while|switch|do|else|try|case|default|extern)\b")


def long_functions(lines):
    """Pairs of first line number and length of the functions above the limit."""
    for start, line in enumerate(lines):
        head = line.rstrip()
        if not head.endswith("{") or "(" not in "".join(lines[max(0, start - 4):start + 1]):
            continue
        if NOT_A_FUNCTION.match(head) or " = {" in head or head.strip() == "{":
            continue
        indent = len(re.match(r"\s*", line).group())
        # A constructor's initialiser list stands four columns in, its closing brace does not.
        closing = " " * (indent - 4 if head.lstrip().startswith(":") else indent) + "}"
        for end in range(start + 1, len(lines)):
            if lines[end].rstrip() in (closing, closing + ";", closing + ");"):
                length = end - start + 1
                if length > FUNCTION_LIMIT:
                    yield start + 1, length
                break


def main():
    root = pathlib.Path(sys.argv[1])
    found = 0
    files = [f for pattern in ("*.h", "*.cc", "*.py") for f in sorted(root.rglob(pattern)) if "build" not in f.relative_to(root).parts]
    for file in files:
        lines = file.read_text(errors="replace").splitlines()
        here = file.relative_to(root).as_posix()
        if len(lines) > FILE_LIMIT:
            print(f"{here}:1: error: {len(lines)} lines, the limit is {FILE_LIMIT}")
            found += 1
        if file.suffix != ".py":
            for number, length in long_functions(lines):
                print(f"{here}:{number}: error: a function of {length} lines, the limit is {FUNCTION_LIMIT}")
                found += 1
    print(f"{len(files)} files, {found} too long")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
