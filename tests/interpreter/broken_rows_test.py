#!/usr/bin/env python3
"""A row that nothing handles must not compile: rows are added to copies of the tables, and the compiler is asked.

Usage: broken_rows_test.py COMPILER INCLUDE...     the first folder is the project
"""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPILER, *INCLUDES = sys.argv[1:]
PROJECT = pathlib.Path(INCLUDES[0])
DIALECTS = pathlib.PurePosixPath("interpreter/dialects")
FLAGS = ["-std=c++20", "-fsyntax-only", "-Wswitch-enum", "-Werror"]

# What is compiled, its table, and rows that go into a copy of it, each with what the compiler must say of it.
BROKEN = [
    ("sinumerik/run/run_system.cc", "sinumerik/vocabulary/system_variables.def", {
        'SYSTEM_VARIABLE(BrandNew, "$P_BRANDNEW", Real, "", Read(brand_new), "shown by nothing")': "brand_new",
        'SYSTEM_VARIABLE(BrandText, "$P_BRANDTEXT", String, "", Read(feed), "")': "$P_BRANDTEXT is of another type",
    }),
    ("sinumerik/vocabulary/system_variables.cc", "sinumerik/vocabulary/system_variables.def", {
        'SYSTEM_VARIABLE(BrandNew, "$P_BRANDNEW", Real, "", Read, "no handler")': "$P_BRANDNEW",
    }),
    ("sinumerik/run/run_procedures.cc", "sinumerik/vocabulary/procedures.def", {
        'PROCEDURE(RESTARTALL, "", "RESTARTALL", "no handler")': "RESTARTALL",
        'PROCEDURE(RESTARTONE, "", Done(restart_one), "RESTARTONE", "done by nothing")': "restart_one",
    }),
    ("sinumerik/vocabulary/functions.cc", "sinumerik/vocabulary/functions.def", {
        'FUNCTION(HALF, Real, "N", OfOne(half), "HALF(a)", "computed by nothing")': "half",
        'FUNCTION(TWICE, Real, "NN", OfOne(sine), "TWICE(a)", "of one number, not two")': "TWICE",
    }),
    ("sinumerik/run/run_functions.cc", "sinumerik/vocabulary/functions.def", {
        'FUNCTION(REVERSE, String, "S", Called(reverse), "REVERSE(s)", "made by nothing")': "reverse",
    }),
    ("sinumerik/execute/positioning.cc", "sinumerik/vocabulary/axis_words.def", {
        'AXIS_WORD(Weight, "WEIGHT", AxisSetting(take_weight), 0.0, 1.0, "taken by nothing")': "take_weight",
    }),
    ("sinumerik/run/run_numbers.cc", "sinumerik/vocabulary/op_codes.def", {"NUMBER_STEP(Halve)": "Halve"}),
    ("sinumerik/run/runner.cc", "sinumerik/vocabulary/op_codes.def", {"RUNNER_STEP(Restart, restart)": "restart"}),
    ("sinumerik/code/compiler.cc", "sinumerik/vocabulary/keywords.def", {
        'KEYWORD(RESTART, calls, restart_statement, "RESTART", "compiled by nothing")': "restart_statement",
    }),
    ("fanuc/state/evaluate.cc", "fanuc/vocabulary/functions.def", {
        'FUNCTION(HALF, "", One, Basic, "computed by nothing")': "HALF",
        'FUNCTION(MEAN, "", Two, Series30i, "computed by nothing")': "MEAN",
    }),
    ("fanuc/execute/block.cc", "fanuc/vocabulary/g_codes.def", {
        'G_CODE(999, 0, OneShot, Modal, "done by nothing")': "G999: nothing does Modal",
        'G_CODE(999, 0, OneShot, CycleOff, "done by nothing")': "G999: nothing does CycleOff",
    }),
    ("fanuc/system/control_variables.cc", "fanuc/vocabulary/system_variables.def", {
        'SYSTEM_VARIABLE(990000, 990000, MacroAlarm, In(Basic), None, Read, Enabled, "shown by nothing")':
            "#990000: MacroAlarm has no function for Read",
    }),
]


def compiled(source, table, rows):
    """Exit code and messages of a source with rows at the end of those of its table."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / DIALECTS / table
        copy.parent.mkdir(parents=True)
        lines = (PROJECT / DIALECTS / table).read_text(encoding="utf-8").splitlines()
        # Some tables end with lines of the preprocessor.
        last = max(i for i, line in enumerate(lines) if line and line[0].isalpha())
        lines[last + 1:last + 1] = rows
        copy.write_text("\n".join(lines) + "\n", encoding="utf-8")
        includes = [f"-I{folder}", *(f"-I{path}" for path in INCLUDES)]
        command = [COMPILER, *FLAGS, *includes, str(PROJECT / DIALECTS / source)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


class BrokenRows(unittest.TestCase):
    def test_a_copy_of_a_table_as_it_is_compiles(self):
        # The build has compiled all of them; one shows that the command below finds what it needs.
        source, table, _ = BROKEN[0]
        code, messages = compiled(source, table, [])
        self.assertEqual(code, 0, messages)

    def test_no_table_compiles_with_a_row_that_nothing_handles(self):
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            broken = [pool.submit(compiled, source, table, list(rows)) for source, table, rows in BROKEN]
        for (_, _, rows), with_rows in zip(BROKEN, broken):
            for row, said in rows.items():
                with self.subTest(row):
                    code, messages = with_rows.result()
                    self.assertNotEqual(code, 0)
                    self.assertIn(said, messages)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
