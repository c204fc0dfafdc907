#!/usr/bin/env python3
"""Ctrl-C while a long document is written: nothing is left of it.  Usage: broken_off_test.py G31"""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

GENEROUS = 30.0  # s
LONG = "O1\n#1=0\nWHILE[#1LT300000]DO1\nG1X1.F1000\nG1X0.\n#1=#1+1\nEND1\nM30\n"


class BrokenOff(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "a.nc").write_text(LONG)

    def writing(self):
        """A run that has begun to write its document, some 100 MB."""
        process = subprocess.Popen([G31, "run", "a.nc", "--json", "a.json", "--moves", "--max-output", "1G"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        began = time.monotonic()
        while not any(path.stat().st_size > 0 for path in self.folder.glob("a.json.*.part")):
            self.assertIsNone(process.poll(), "it has ended before")
            self.assertLess(time.monotonic() - began, GENEROUS)
            time.sleep(0.01)
        return process

    def left(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_the_first_one_ends_the_writing(self):
        process = self.writing()
        process.send_signal(signal.SIGINT)
        errors = process.communicate(timeout=GENEROUS)[1]
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("a.json", errors)
        self.assertEqual(self.left(), ["a.nc"])

    def test_a_second_one_leaves_nothing_either(self):
        process = self.writing()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=GENEROUS)
        self.assertIn(process.returncode, (130, -signal.SIGINT))
        self.assertEqual(self.left(), ["a.nc"])

    def test_a_document_of_an_earlier_run_stays(self):
        (self.folder / "a.json").write_text('{"schema": "g31.run/1"}')
        process = self.writing()
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=GENEROUS)
        self.assertEqual(process.returncode, 130)
        self.assertEqual((self.folder / "a.json").read_text(), '{"schema": "g31.run/1"}')
        self.assertEqual(self.left(), ["a.json", "a.nc"])


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
