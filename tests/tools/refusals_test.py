#!/usr/bin/env python3
"""Words and files that a command refuses: numbers out of their range, topics that are none, files that are not there;
and what its document says then.

Usage: refusals_test.py G31
"""
import json
import pathlib
import sys
import tempfile
import unittest

import kept_documents

RUNS = "%\nO1\n#500=3\nM30\n%\n"


class Refusals(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def g31(self, *words):
        return kept_documents.run([G31, *words], self.folder, capture_output=True, text=True)

    def test_a_program_changes_and_deletes_nothing_that_its_run_is_made_of(self):
        sheet = '[control]\nprofile = "sinumerik-828d"\nfiles = "."\n'
        for does in ('WRITE(E,"w.toml","x")', 'DELETE(E,"w.mpf")'):
            program = f'DEF INT E\nWRITE(E,"log.txt","x")\n{does}\nM30\n'
            (self.folder / "w.mpf").write_text(program)
            (self.folder / "w.toml").write_text(sheet)
            run = self.g31("run", "w.mpf", "-s", "w.toml", "--json", "a.json")
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn("of which the run is made: none of its files is kept", run.stderr)
            self.assertEqual(json.loads((self.folder / "a.json").read_text())["exit_code"], 2)
            self.assertEqual((self.folder / "w.mpf").read_text(), program)
            self.assertEqual((self.folder / "w.toml").read_text(), sheet)
            self.assertFalse((self.folder / "log.txt").exists())

    def test_a_whole_number_is_one_in_its_range(self):
        largest, exact = 2**64 - 1, 2**53
        run, study = ("run", "a.nc"), ("study", "a.toml")
        for words, option, least, most in (
                (run, "--seed", 0, largest), (run, "--max-blocks", 0, largest), (run, "--block-skip", 1, 9),
                (("scene", "a.nc", "-o", "a.svg"), "--seed", 0, largest), (("view", "a.nc"), "--port", 0, 65535),
                (("scene", "a.nc", "-o", "a.svg"), "--width", 600, 4000), (study, "--seed", 0, exact),
                (study, "--repeats", 1, 10_000_000), (study, "--threads", 1, 1024)):
            for number in ("1.5", "1e3", "-1", "nan", "0x10", "", str(most + 1), str(least - 1), str(most * 2), "9" * 26):
                refused = self.g31(*words, f"{option}={number}")
                self.assertEqual((refused.returncode, refused.stdout), (2, ""), (words, option, number, refused.stderr))
                if number:
                    self.assertIn(f"{option}: {number} is not a whole number from {least} to {most}", refused.stderr)
            self.assertIn(f"INT in [{least} - {most}]", " ".join(self.g31(words[0], "--help").stdout.split()), option)

    def test_a_seed_is_taken_to_its_last_digit(self):
        (self.folder / "a.nc").write_text(RUNS)
        for given, taken in (("18446744073709551615", 2**64 - 1), ("9007199254740993", 2**53 + 1), ("010", 10), ("0", 0)):
            run = self.g31("run", "a.nc", "--seed", given, "--json", "-")
            self.assertEqual((run.returncode, json.loads(run.stdout)["seed"]), (0, taken), run.stderr)
        (self.folder / "a.toml").write_text('[study]\nprogram = "a.nc"\n[results.one]\nvalue = "#500"\n')
        study = self.g31("study", "a.toml", "--seed", str(2**53), "--json", "-")
        self.assertEqual((study.returncode, json.loads(study.stdout)["study"]["seed"]), (0, 2**53), study.stderr)

    def test_no_topic_is_none(self):
        for blank in ("", " ", "  \t"):
            run = self.g31("explain", blank)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("the word is empty", run.stderr)

    def test_a_refused_explain_has_its_document_on_standard_output(self):
        for words in (("--json",), ("--search", "--json"), ("foo", "--page", "x", "--json"), ("--json", "--", ""),
                      ("#500", "--json", "-", "--controll", "haas"), ("no_such_word", "--json")):
            run = self.g31("explain", *words)
            self.assertEqual(run.returncode, 2, words)
            document = json.loads(run.stdout)
            self.assertEqual((document["schema"], document["status"], document["exit_code"]), ("g31.explain/1", "usage", 2), words)
            self.assertEqual(len(document["diagnostics"]), 1, words)

    def test_words_that_are_known_are_told_beside_those_that_are_not(self):
        run = self.g31("explain", "G31", "no_such_word", "--json")
        document = json.loads(run.stdout)
        self.assertEqual((run.returncode, document["exit_code"], document["entries"][0]["name"]), (2, 2, "G31"))
        self.assertIn("no_such_word", document["diagnostics"][0]["message"])
        self.assertIn("g31: error: nothing is known about 'no_such_word'", run.stderr)

    def test_a_check_of_files_that_are_not_there_says_how_it_ended(self):
        (self.folder / "a.nc").write_text(RUNS)
        for words, ends in ((("a.nc",), None), (("a.nc", "no.nc"), 2), (("no.nc",), 2)):
            run = self.g31("check", *words, "--json", "-")
            document = json.loads(run.stdout)
            self.assertEqual((document.get("status"), document.get("exit_code")), ("usage", 2) if ends else (None, None))
            self.assertEqual(run.returncode, ends or 0, run.stderr)

    def test_standard_input_is_checked_once(self):
        for words in (("-", "-"), ("-", "--baseline", "-"), ("-", "--setup", "-")):
            run = self.g31("check", *words)
            self.assertEqual(run.returncode, 2)
            self.assertIn("- is standard input, which can be one file; here it is 2", run.stderr)

    def test_a_set_up_whose_variables_cannot_be_saved_is_none(self):
        (self.folder / "a.nc").write_text(RUNS)
        (self.folder / "s.toml").write_text('[control]\nvariables_file = "nodir/x.vars"\n')
        (self.folder / "kept").mkdir()
        (self.folder / "t.toml").write_text('[control]\nvariables_file = "kept/x.vars"\n')
        run = self.g31("run", "a.nc", "-s", "s.toml", "-q")
        self.assertEqual(run.returncode, 2)
        self.assertIn("nodir/x.vars: the run could not save its variables here (No such file or directory)", run.stderr)
        for words in (("s.toml",), ("s.toml", "--program", "a.nc")):
            setup = self.g31("setup", *words)
            self.assertEqual((setup.returncode, setup.stderr), (2, run.stderr), words)
        self.assertEqual(self.g31("setup", "t.toml").returncode, 0)
        self.assertEqual(list((self.folder / "kept").iterdir()), [], "nothing is kept")

    def test_a_record_without_rows_is_refused_with_its_line(self):
        for text, line in (("X,Y\n", 1), ("# made by hand\n\nX,Y\n\n# no more\n", 3)):
            (self.folder / "q.csv").write_text(text)
            run = self.g31("evaluate", "diagonal", "q.csv", "--target", "1,1", "--json", "-")
            self.assertEqual(run.returncode, 2)
            self.assertIn(f"q.csv:{line}:1: error: there are no rows below the names of the columns [DAT109]", run.stderr)
            self.assertEqual(json.loads(run.stdout)["diagnostics"][0]["line"], line)


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
