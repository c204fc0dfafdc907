#!/usr/bin/env python3
"""Fails where code gets round what the compiler knows of an enumeration.

A row added to a table must be a compile error until something handles it.  Casts in case labels hide from the
compiler which enumerators a switch leaves out; a comparison by order makes the place of a row mean something.
What no switch is over has to be named somewhere: an alarm where it is raised, an address where it is read, unless its
text says that it is not simulated.  A code of a message means one message.
Usage: check_tables.py REPOSITORY
"""
import pathlib
import re
import sys

from source_tree import files_of, report

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'', re.DOTALL)
# Digits in groups, 1'000'000, are no characters in quotes.
DIGIT_MARK = re.compile(r"(?<=\d)'(?=\d)")
COMPUTED_LABEL = re.compile(r"\bcase\s+(?:\w|::|[<>,\s])*\(")
COMPUTED_SWITCH = re.compile(r"\bswitch \(static_cast<(?:unsigned|(?:std::)?u?int\w*|(?:std::)?size_t)>\(")
ENUMERATOR = r"(?:\w+::)*[A-Z]\w*::[A-Z]\w*"
ORDER = re.compile(rf"(?<=\s)[<>]=?\s+{ENUMERATOR}(?![\w:(<{{.])|(?<![\w:]){ENUMERATOR}\s+[<>]=?(?=\s)")


# Tables whose rows are taken up one by one: file name, macro, enumeration.
NAMED_ROWS = (("alarms.def", "ALARM", "AlarmId"), ("addresses.def", "ADDRESS", "Address"))
NOT_SIMULATED = "not simulated"
# Rows whose second column is the code that documents and users know them by.
CODED_ROW = re.compile(r'(?:DIAGNOSTIC|RULE|SETUP_RULE|SETUP_ERROR|DATA_ERROR)\((\w+),\s*"([A-Z]+\d+)"')


def code_of(text):
    """The text without comments and literals, every line where it was."""
    text = DIGIT_MARK.sub(" ", text)
    return NOT_CODE.sub(lambda found: "\n" * found[0].count("\n") or " ", text)


def problems_of(here, text):
    """Problems of one file."""
    code = code_of(text)
    for pattern, problem in (
        (COMPUTED_LABEL, "a case label names its enumerator as it is: a cast hides the missing ones"),
        (COMPUTED_SWITCH, "a switch over numbers: over the enumeration the compiler knows the missing ones"),
        (ORDER, "enumerators have no order: a column of the table, or a switch over all of them"),
    ):
        for found in pattern.finditer(code):
            yield here, code.count("\n", 0, found.start()) + 1, problem


def unnamed_rows(root, files):
    """Rows of tables that nothing in their dialect names."""
    for table in (file for file in files if file.name in [name for name, _, _ in NAMED_ROWS]):
        macro, enumeration = next((m, e) for name, m, e in NAMED_ROWS if name == table.name)
        dialect = table.parent.parent
        users = [f for f in files if dialect in f.parents and f != table]
        named = set(re.findall(rf"\b{enumeration}::(\w+)", "".join(code_of(f.read_text(encoding="utf-8")) for f in users)))
        for number, line in enumerate(table.read_text(encoding="utf-8").splitlines(), 1):
            row = re.match(rf"{macro}\((\w+)", line)
            if row and row[1] not in named and NOT_SIMULATED not in line:
                yield table.relative_to(root).as_posix(), number, f"nothing names {enumeration}::{row[1]}"


def repeated_codes(root, files):
    """Codes that two rows have."""
    first = {}
    for table in (file for file in files if file.suffix == ".def"):
        for number, line in enumerate(table.read_text(encoding="utf-8").splitlines(), 1):
            row = CODED_ROW.match(line)
            if row and first.setdefault(row[2], row[1]) != row[1]:
                yield table.relative_to(root).as_posix(), number, f"{row[2]} is the code of {first[row[2]]}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = files_of(root, ".h", ".cc")
    problems = [
        problem
        for file in files
        for problem in problems_of(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))
    ]
    problems += unnamed_rows(root, files_of(root, ".h", ".cc", ".def"))
    problems += repeated_codes(root, files_of(root, ".h", ".cc", ".def"))
    return report(problems, f"tables: {len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
