#!/usr/bin/env python3
"""What Python tests have g31 write is kept, and a document that its schema does not take is found.

Usage: kept_documents_test.py
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import documents_of_tests_test
import kept_documents

CHECK = pathlib.Path(__file__).resolve().parent / "documents_of_tests_test.py"
GOOD = '{"schema": "g31.version/1", "version": "1.2.3", "commands": ["run"], "controls": ["fanuc-16i"]}\n'
WRITES = [sys.executable, "-c", "import sys; open(sys.argv[2], 'w').write(sys.argv[3])"]


class Kept(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = pathlib.Path(folder.name) / "work"
        self.work.mkdir()
        self.kept = pathlib.Path(folder.name) / "kept"
        before = os.environ.get("G31_KEPT_DOCUMENTS")
        os.environ["G31_KEPT_DOCUMENTS"] = str(self.kept)
        self.addCleanup(lambda: os.environ.pop("G31_KEPT_DOCUMENTS") if before is None
                        else os.environ.update(G31_KEPT_DOCUMENTS=before))

    def prints(self, text):
        kept_documents.run([sys.executable, "-c", f"print({text!r})"], self.work, capture_output=True, text=True)

    def checked(self):
        done = subprocess.run([sys.executable, "-B", CHECK, self.kept], capture_output=True, text=True, check=False)
        if done.returncode == 77 and "jsonschema" in done.stdout:
            self.skipTest("python3-jsonschema is not installed")
        return done.returncode, done.stdout

    def test_one_of_standard_output_and_one_of_a_file(self):
        self.prints("#500 = 3\n" + GOOD)
        kept_documents.run([*WRITES, "--json", "a.json", GOOD.replace("1.2.3", "1.2.4")], self.work)
        self.assertEqual(self.checked(), (0, "g31.version: 2\n"))
        self.assertEqual(self.checked()[0], 77, "they are taken away")

    def test_a_folder_of_them(self):
        (self.work / "below").mkdir()
        (self.work / "below/a.jsonl").write_text('{"event": "start", "schema": "g31.events/1"}\n')
        kept_documents.keep_folder(self.work)
        code, said = self.checked()
        self.assertEqual(code, 1)
        self.assertIn("g31.events: $: ", said)

    def test_a_wrong_one_is_found(self):
        for text in (GOOD.replace('"1.2.3"', "5"), GOOD.replace("}\n", ', "more": 1}\n'), GOOD.replace("version/1", "other/1")):
            self.prints(text)
            self.assertEqual(self.checked()[0], 1, text)

    def test_of_rows_that_a_schema_takes_alike_one_is_looked_at(self):
        alike = [{"line": line, "at": [line, -1.5, None]} for line in range(1, 30)]
        others = [{"line": 0, "at": [1, 2.5, None]}, {"line": -1, "at": [1, 2.5, None]}, {"line": 1.5, "at": [1, 2.5, None]},
                  {"line": "1", "at": [1, 2.5, None]}, {"line": 1, "at": [1, 2.5]}, {"line": 1, "at": [1, 2.5, 3.5]}, {"row": 1}]
        rows = documents_of_tests_test.without_like_rows({"rows": alike[:15] + others + alike[15:]})["rows"]
        self.assertEqual(rows[1:], others)
        self.assertIn(rows[0], alike)
        numbers = {"points": [[1.0, 2.0]] * 20}
        self.assertEqual(documents_of_tests_test.without_like_rows(numbers), numbers)

    def test_what_is_none_is_left_alone(self):
        self.prints('{"schema": "other/1"}')
        self.prints("g31.run")
        kept_documents.run([*WRITES, "--json", "a.nc", GOOD], self.work)
        self.assertFalse(self.kept.exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
