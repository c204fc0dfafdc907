#!/usr/bin/env python3
"""The checkers of the house on made-up trees: a check that finds nothing wrong in a wrong tree is worthless."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

DEV = pathlib.Path(__file__).resolve().parents[2] / "tools" / "dev"


def run(checker, files):
    """Exit code and output of a checker on a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([sys.executable, str(DEV / checker), folder], capture_output=True, text=True)
        return done.returncode, done.stdout


class Layers(unittest.TestCase):
    def test_an_allowed_include_passes(self):
        code, _ = run("check_layers.py", {"machine/sim/a.cc": '#include "machine/port/machine_port.h"\n'})
        self.assertEqual(code, 0)

    def test_the_probe_may_not_know_the_interpreter(self):
        code, out = run("check_layers.py", {"probe/contact/a.cc": '#include "interpreter/source/source_file.h"\n'})
        self.assertEqual(code, 1)
        self.assertIn("probe/contact/a.cc:1: error: probe/contact may not include interpreter/source/source_file.h", out)

    def test_dialects_may_not_know_each_other(self):
        code, _ = run("check_layers.py", {"interpreter/dialects/fanuc/a.h": '#include "interpreter/dialects/sinumerik/b.h"\n'})
        self.assertEqual(code, 1)

    def test_machine_base_knows_nobody(self):
        code, _ = run("check_layers.py", {"machine/base/a.h": '#include "machine/units/units.h"\n'})
        self.assertEqual(code, 1)


class Sizes(unittest.TestCase):
    def test_a_short_file_passes(self):
        self.assertEqual(run("check_sizes.py", {"a.cc": "int f() {\n  return 1;\n}\n"})[0], 0)

    def test_a_long_file_is_found(self):
        code, out = run("check_sizes.py", {"a.cc": "\n" * 601})
        self.assertEqual(code, 1)
        self.assertIn("a.cc:1: error: 601 lines", out)

    def test_a_long_function_is_found(self):
        code, out = run("check_sizes.py", {"a.cc": "int f() {\n" + "  g();\n" * 60 + "}\n"})
        self.assertEqual(code, 1)
        self.assertIn("a.cc:1: error: a function of 62 lines", out)


if __name__ == "__main__":
    unittest.main()
