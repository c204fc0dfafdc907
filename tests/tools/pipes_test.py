#!/usr/bin/env python3
"""Pipes as inputs and outputs: what comes through them, and that nobody waits at one longer than wanted.

Usage: pipes_test.py G31
"""
import fcntl
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

GENEROUS = 30.0  # s; what is waited for comes within one on a machine that is not busy
PROMPT = 5.0
PROGRAM = "%\nO1\n#500=3\nM30\n%\n"
SHEET = '[variables]\n"#501" = 7.0\n'
READINGS = "axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0.002\nX,9,1,1,9\nX,9,1,2,9.001\n"


class Pipes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.pipe = self.folder / "pipe"
        os.mkfifo(self.pipe)
        (self.folder / "a.nc").write_text(PROGRAM)

    def start(self, *words):
        process = subprocess.Popen([G31, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.addCleanup(lambda: self.stop(process))
        return process

    @staticmethod
    def stop(process):
        if process.poll() is None:
            process.kill()
            process.communicate()

    def g31(self, *words):
        run = subprocess.run([G31, *words], cwd=self.folder, capture_output=True, text=True, timeout=GENEROUS)
        return run.returncode, run.stdout, run.stderr

    def interrupted(self, process):
        """How a process ends at the first Ctrl-C, and what it says."""
        time.sleep(0.5)
        self.assertIsNone(process.poll(), "it does not wait")
        began = time.monotonic()
        process.send_signal(signal.SIGINT)
        errors = process.communicate(timeout=GENEROUS)[1]
        self.assertLess(time.monotonic() - began, PROMPT)
        return process.returncode, errors


class Inputs(Pipes):
    def bring(self, text, after=0.3):
        """Somebody comes later and writes."""
        def write():
            time.sleep(after)
            with open(self.pipe, "w") as pipe:
                pipe.write(text[:5])
                pipe.flush()
                time.sleep(0.2)
                pipe.write(text[5:])
        writer = threading.Thread(target=write, daemon=True)
        writer.start()
        self.addCleanup(writer.join, 1.0)

    def test_what_a_writer_brings_later_is_read_once_and_whole(self):
        rows = ((PROGRAM, ("run", "pipe", "--print", "#500"), "#500 = 3\n"),
                (PROGRAM, ("run", "pipe", "--json", "a.json", "--print", "#500"), "#500 = 3\n"),
                (SHEET, ("run", "a.nc", "-s", "pipe", "--print", "#501"), "#501 = 7\n"),
                (READINGS, ("evaluate", "positioning", "pipe"), None),
                (PROGRAM, ("check", "pipe"), None))
        for text, words, said in rows:
            self.bring(text)
            code, out, errors = self.g31(*words)
            self.assertEqual(code, 0, f"{words}: {out} {errors}")
            self.assertIn(said or "", out)

    def test_what_a_shell_brings_is_read(self):
        run = subprocess.run(["bash", "-c", f'"{G31}" run <(cat a.nc) --print "#500"'], cwd=self.folder,
                             capture_output=True, text=True, timeout=GENEROUS)
        self.assertEqual((run.returncode, run.stdout), (0, "#500 = 3\n"), run.stderr)

    def test_the_first_ctrl_c_ends_the_waiting_for_a_writer(self):
        (self.folder / "study.toml").write_text('[study]\nprogram = "pipe"\n[results.r]\nvalue = "#500"\n')
        (self.folder / "kept.toml").write_text('[control]\nvariables_file = "pipe"\n')
        for words in (("run", "pipe"), ("run", "a.nc", "pipe"), ("run", "a.nc", "-s", "pipe"),
                      ("run", "a.nc", "-s", "kept.toml"), ("scene", "pipe", "-o", "a.svg"),
                      ("evaluate", "circle", "pipe", "--json", "a.json"), ("judge", "pipe", "a.nc"),
                      ("study", "pipe"), ("study", "study.toml", "--json", "a.json"), ("check", "pipe")):
            code, errors = self.interrupted(self.start(*words))
            self.assertIn(code, (130, -signal.SIGINT), f"{words}: {errors}")
            self.assertEqual(code == 130, "interrupted" in errors, f"{words}: {errors}")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir() if ".lock" not in path.name),
                         ["a.nc", "kept.toml", "pipe", "study.toml"])

    def test_a_view_ends_too(self):
        code, errors = self.interrupted(self.start("view", "pipe"))
        self.assertEqual(code, 130, errors)

    def test_a_document_tells_that_the_waiting_was_interrupted(self):
        code, errors = self.interrupted(self.start("run", "pipe", "--json", "a.json"))
        self.assertEqual(code, 130, errors)
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["status"], "interrupted")

    def test_the_limit_of_time_ends_the_waiting_for_a_writer(self):
        for words in (("run", "pipe"), ("run", "a.nc", "-s", "pipe"), ("scene", "pipe", "-o", "a.svg"),
                      ("evaluate", "circle", "pipe")):
            code, _, errors = self.g31(*words, "--max-time", "0.4")
            self.assertEqual(code, 6, f"{words}: {errors}")
            self.assertIn("the waiting for an input that nobody writes to: --max-time raises it", errors)

    def test_a_part_is_no_pipe(self):
        for name in ("part.step", "part.stl"):
            os.mkfifo(self.folder / name)
            code, _, errors = self.g31("plan", name, "--stock", "box", "-o", "out")
            self.assertEqual(code, 2, errors)
            if "without Open CASCADE" not in errors:
                self.assertIn("a part is read from a regular file", errors)


class Outputs(Pipes):
    """Whoever reads has opened the pipe."""
    MOVES = "%\nO1\n" + "G0X1.\nX0.\n" * 500 + "M30\n%\n"
    PRINTS = "%\nO1\nPOPEN\nN1DPRNT[THE*SAME*LINE*AGAIN*AND*AGAIN]\nGOTO1\n%\n"

    def setUp(self):
        super().setUp()
        (self.folder / "moves.nc").write_text(self.MOVES)
        (self.folder / "prints.nc").write_text(self.PRINTS)
        self.reader = os.open(self.pipe, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, self.reader)
        fcntl.fcntl(self.reader, fcntl.F_SETPIPE_SZ, 4096)

    STUCK = (("run", "moves.nc", "--moves", "--json", "pipe"), ("run", "moves.nc", "--jsonl", "pipe"),
             ("run", "moves.nc", "--trace", "pipe"), ("run", "prints.nc", "--printer", "pipe"))

    def test_the_limit_of_time_ends_the_waiting_for_a_reader_that_takes_nothing(self):
        for words in self.STUCK:
            began = time.monotonic()
            code, _, errors = self.g31(*words, "--max-time", "0.5")
            self.assertEqual(code, 6, f"{words}: {errors}")
            self.assertIn("the limit of computing time is reached and whoever reads this pipe takes nothing", errors)
            self.assertLess(time.monotonic() - began, PROMPT)

    def test_so_does_the_first_ctrl_c(self):
        for words in self.STUCK:
            code, errors = self.interrupted(self.start(*words))
            self.assertEqual(code, 130, f"{words}: {errors}")

    def test_nor_is_a_reader_waited_for_that_does_not_come(self):
        other = self.folder / "other"
        os.mkfifo(other)
        began = time.monotonic()
        code, _, errors = self.g31("run", "a.nc", "--json", "other", "--max-time", "0.1")
        self.assertEqual(code, 6, errors)
        self.assertLess(time.monotonic() - began, 2.5, "3 s without a limit")

    def test_every_output_waits_for_its_reader(self):
        (self.folder / "says.nc").write_text("%\nO1\nPOPEN\nDPRNT[HELLO]\nPCLOS\nM30\n%\n")
        other = self.folder / "other"
        os.mkfifo(other)
        for option in ("--printer", "--json", "--jsonl", "--trace"):
            run = self.start("run", "says.nc", option, "other")
            time.sleep(0.5)
            self.assertIsNone(run.poll(), option)
            with open(other) as reader:
                text = reader.read()
            self.assertEqual(run.wait(timeout=GENEROUS), 0, option)
            self.assertTrue(text, option)
            if option == "--printer":
                self.assertEqual(text, "HELLO\n")

    def test_a_reader_that_is_a_little_late_gets_all(self):
        (self.folder / "ends.nc").write_text(self.MOVES.replace("M30", "N1GOTO1"))
        run = self.start("run", "ends.nc", "--moves", "--json", "pipe", "--max-time", "0.5")
        time.sleep(1.0)
        os.set_blocking(self.reader, True)
        text = b""
        while piece := os.read(self.reader, 65536):
            text += piece
        run.communicate(timeout=GENEROUS)
        self.assertEqual(run.returncode, 6)
        document = json.loads(text)
        self.assertEqual((document["status"], len(document["moves"])), ("budget", 1000))


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
