#!/usr/bin/env python3
"""docs/examples, followed to the letter: every command of its README, and the pipeline with good and bad programs.

Usage: examples_test.py G31
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import kept_documents

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "examples"


class Examples(unittest.TestCase):
    """Each test works in a copy: the programs keep what they calibrated beside them."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name) / "examples"
        shutil.copytree(EXAMPLES, self.root)
        path = pathlib.Path(folder.name) / "bin"
        path.mkdir()
        (path / "g31").symlink_to(G31)
        self.environment = {**os.environ, "PATH": f"{path}:{os.environ['PATH']}"}
        self.environment.pop("GITHUB_ACTIONS", None)

    def call(self, folder, *words, **more):
        done = subprocess.run(words, cwd=self.root / folder, capture_output=True, text=True,
                              env={**self.environment, **more})
        kept_documents.keep_folder(self.root)
        return done

    def test_each_command_of_the_readme_completes(self):
        sections = (EXAMPLES / "README.md").read_text().split("\n## ")[1:]
        commands = [(section.split(":")[0], line.split())
                    for section in sections for line in re.findall(r"^    (g31 .*)$", section, re.MULTILINE)]
        self.assertEqual(len(commands), 4)
        printed = ""
        for folder, words in commands:
            run = self.call(folder, *words)
            self.assertEqual(run.returncode, 0, f"{words}: {run.stderr}")
            printed += run.stdout
        self.assertIn("BORE   40.020 ERROR    0.020", printed)
        self.assertIn("BORE 40.02\n", printed)

    def test_without_calibration_the_bore_reads_as_the_readme_says(self):
        # 4 ms late at 30 mm/min on both sides: 0.004 mm more than 40.02.
        run = self.call("fanuc", "g31", "run", "inspect.nc", "-s", "machine.toml", "-s", "0i.toml", "-s",
                        "flange.toml", "--set", "#501=3", "--set", "#502=3", "--print", "#138")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(run.stdout, r"#138 = 40\.02(4|399999)")
        self.assertIn("#138: expected 40.02 +- 0.001", run.stderr)

    def test_the_pipeline_passes_and_leaves_documents(self):
        for folder, documents in (("fanuc", ("inspect-0i", "inspect-30i")), ("sinumerik", ("measure",))):
            run = self.call(".", "pipeline/pipeline.sh", folder)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            for name in documents:
                document = json.loads((self.root / folder / f"{name}.json").read_text())
                self.assertEqual((document["status"], document["exit_code"]), ("completed", 0))

    def test_a_program_that_breaks_fails_the_job_with_an_annotation(self):
        program = self.root / "fanuc" / "O9814.nc"
        program.write_text(program.read_text().replace("#10=0\n", "#10=[0\n"))
        run = self.call(".", "pipeline/pipeline.sh", "fanuc", GITHUB_ACTIONS="true")
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertRegex(run.stdout, r"::error file=fanuc/O9814\.nc,line=7,.*::")

    def test_a_part_that_is_not_right_fails_the_job(self):
        sheet = self.root / "sinumerik" / "flange.toml"
        sheet.write_text(sheet.read_text().replace("bore = 40.02\n", "bore = 40.2\n"))
        run = self.call(".", "pipeline/pipeline.sh", "sinumerik")
        self.assertEqual(run.returncode, 3, run.stdout + run.stderr)
        self.assertIn("BORE OUT OF TOLERANCE [65001]", run.stderr)


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
