#!/usr/bin/env python3
"""What long work says on a terminal of how far it is, and how it ends where somebody ends it.

Usage: progress_test.py G31
"""
import fcntl
import os
import pathlib
import pty
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import unittest
import unittest.mock

from caught_signals import wait_until_it_catches

os.environ["TERM"] = "xterm"  # as a terminal is, whatever the tests themselves write to


class Progress(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def seen_on_a_terminal(self, *words):
        """What a command shows on standard error where that is a terminal."""
        ours, its = pty.openpty()
        shown = subprocess.Popen([G31, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=its, text=True)
        os.close(its)
        seen = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # nobody writes any more
                break
            seen += piece
            if not piece:
                break
        os.close(ours)
        shown.communicate()
        return seen.decode()

    def test_a_long_run_says_on_a_terminal_how_far_it_is(self):
        (self.folder / "a.nc").write_text("%\nO1\nN1 GOTO1\nM30\n%\n")
        words = ("run", "a.nc", "--max-blocks", "100000000000", "--max-time", "2")
        seen = self.seen_on_a_terminal(*words)
        self.assertRegex(seen, r"\rrunning: \d+ blocks, 0 s of machine time, 1 s here\x1b\[K")
        self.assertRegex(seen.rsplit("running", 1)[1], r"^[^\n]*\x1b\[K\r\x1b\[K", "gone before the messages")
        self.assertNotIn("running", self.seen_on_a_terminal(*words, "-q"))
        piped = subprocess.run([G31, *words], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(piped.returncode, 6)
        self.assertNotIn("running", piped.stderr)

    def test_so_does_a_scene_but_not_on_a_terminal_that_takes_nothing_back(self):
        (self.folder / "a.nc").write_text("%\nO1\nN1 GOTO1\nM30\n%\n")
        words = ("scene", "a.nc", "-o", "a.svg", "--max-blocks", "100000000000", "--max-time", "2")
        self.assertIn("\rrunning: ", self.seen_on_a_terminal(*words))
        self.assertNotIn("running", self.seen_on_a_terminal(*words, "-q"))
        with unittest.mock.patch.dict(os.environ, {"TERM": "dumb"}):
            self.assertNotIn("running", self.seen_on_a_terminal(*words))

    def test_progress_stays_in_one_line_of_a_narrow_terminal(self):
        (self.folder / "a.nc").write_text("O1\n#1=0\nWHILE[#1LT3000]DO1\n#1=#1+1\nEND1\n#501=#1\nM30\n")
        (self.folder / "s.toml").write_text(
            '[study]\nprogram = "a.nc"\nrepeats = 400\n[results.one]\nvalue = "#501"\n')
        for columns, bar in ((40, False), (120, True)):
            ours, theirs = pty.openpty()
            fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 20, columns, 0, 0))
            work = subprocess.Popen([G31, "study", "s.toml", "--repeats", "100000", "--threads", "1"], cwd=self.folder,
                                    stdout=subprocess.DEVNULL, stderr=theirs)
            os.close(theirs)
            shown = b""
            while shown.count(b"\r") < 4:
                shown += os.read(ours, 4096)
            work.send_signal(signal.SIGINT)
            try:
                while os.read(ours, 4096):
                    pass
            except OSError:
                pass  # the other side is closed
            work.wait(timeout=60)
            os.close(ours)
            for line in shown.split(b"\r")[1:-1]:
                text = line.replace(b"\x1b[K", b"").decode()
                self.assertLess(len(text), columns, text)
                self.assertEqual(text.startswith("["), bar, text)
                self.assertIn(" of 100000 runs, ", text)

    def test_check_is_interrupted_between_two_files(self):
        for i in range(300):
            (self.folder / f"{i}.nc").write_text("%\nO1\n" + "G1X1.F100.\n" * 5000 + "M30\n%\n")
        before = len(list(self.folder.iterdir()))
        for ending in (signal.SIGINT, signal.SIGTERM):
            check = subprocess.Popen([G31, "check", ".", "--json", "found.json"], cwd=self.folder,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            wait_until_it_catches(check, ending)
            check.send_signal(ending)
            errors = check.communicate(timeout=60)[1]
            self.assertEqual((check.returncode, errors), (130, "g31: error: interrupted\n"))
            self.assertEqual(len(list(self.folder.iterdir())), before, "no document of half of them")


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
