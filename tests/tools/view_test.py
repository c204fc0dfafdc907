#!/usr/bin/env python3
"""g31 view: who is answered, what a save in an editor does, and how it ends; --report of a run that is refused.

Usage: view_test.py G31
"""
import http.client
import json
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

GENEROUS = 20.0  # s; a page is new within one on a machine that is not busy
PROGRAM = "%\nO1\n#500={}(A VALUE)\nM30\n%\n"
BROKEN = "%\nO1\n#500=[1+\nM30\n%\n"


class Served(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("a.nc", PROGRAM.format(3))

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def start(self, *words):
        self.view = subprocess.Popen([G31, "view", "a.nc", *words], cwd=self.folder, stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        self.line = self.view.stdout.readline()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?t=([0-9a-f]{32})\n", self.line)
        self.assertTrue(found, self.line)
        self.port, self.token = int(found[1]), found[2]

    def stop(self):
        if self.view.poll() is None:
            self.view.kill()
        self.view.communicate()

    def ask(self, path=None, method="GET", **headers):
        link = http.client.HTTPConnection("127.0.0.1", self.port, timeout=GENEROUS)
        link.request(method, path or f"/?t={self.token}", headers=headers)
        answer = link.getresponse()
        text = answer.read().decode()
        link.close()
        self.headers = answer.headers
        return answer.status, text

    def listen(self):
        """A connection that hears of editions."""
        link = http.client.HTTPConnection("127.0.0.1", self.port, timeout=GENEROUS)
        link.request("GET", f"/events?t={self.token}")
        answer = link.getresponse()
        self.addCleanup(link.close)
        self.assertEqual((answer.status, answer.headers["Content-Type"]), (200, "text/event-stream"))
        return answer

    def heard(self, answer):
        while True:
            line = answer.readline().decode()
            self.assertTrue(line, "the server has hung up")
            if line.startswith("data: "):
                return int(line[6:])

    def hears_of_work(self, answer):
        """Of a newer page that is made, before the page itself."""
        while True:
            line = answer.readline().decode()
            self.assertFalse(line.startswith("data: "), line)
            if line == "event: works\n":
                return

    def until(self, *texts):
        """The page that has all of these, and how long it took to come."""
        began = time.monotonic()
        while time.monotonic() - began < GENEROUS:
            status, page = self.ask()
            if status == 200 and all(text in page for text in texts):
                return page, time.monotonic() - began
            time.sleep(0.02)
        self.fail(f"no page with {texts}: {page[:2000]}")


class Safety(Served):
    def test_only_who_has_the_token_is_answered_and_only_here(self):
        self.start()
        self.assertEqual(self.ask()[0], 200)
        self.assertIn("connect-src 'self'", self.ask()[1])
        self.assertEqual(self.headers["Cache-Control"], "no-store")
        for path in ("/", "/?t=", f"/?t={self.token[:-1]}", f"/?t={self.token}0", "/?t=" + "0" * 32, "/events",
                     f"/?T={self.token}", f"/?t=0&t={self.token}"):
            status, text = self.ask(path)
            self.assertEqual((status, text), (403, "403\n"), path)
        for host in (f"evil.example:{self.port}", "127.0.0.1", f"127.0.0.1:{self.port + 1}", "localhost",
                     f"localhost.evil.example:{self.port}"):
            self.assertEqual(self.ask(Host=host)[0], 403, host)
        self.assertEqual(self.ask(Host=f"localhost:{self.port}")[0], 200)

    def test_no_other_path_and_no_other_method(self):
        self.start()
        for path in ("/a.nc", "/..%2fa.nc", "/../../etc/passwd", "//", "/events/", "/favicon.ico"):
            self.assertEqual(self.ask(f"{path}?t={self.token}")[0], 404, path)
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "HEAD", "PATCH"):
            self.assertEqual(self.ask(method=method)[0], 405, method)

        self.assertEqual(self.headers["Allow"], "GET")

    def test_a_range_is_answered_with_the_whole_page_and_nothing_behind_it(self):
        self.start()
        page, _ = self.until("Completed")
        size = len(page.encode())
        for wanted in ("0-99", f"{size}-{size + 99}", f"{size - 10}-9999999", "99999999-", "-5", "0-1,3-4,99999999-"):
            status, text = self.ask(Range=f"bytes={wanted}")
            self.assertEqual((status, self.headers["Accept-Ranges"], self.headers["Content-Range"]), (200, "none", None), wanted)
            self.assertTrue(text == page, wanted)
        self.assertEqual(self.ask(Range="bytes=9-3")[0], 416)

    def test_it_listens_at_the_loopback_alone(self):
        self.start()
        listening = [line.split()[1] for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]
                     if line.split()[3] == "0A" and line.split()[1].endswith(f":{self.port:04X}")]
        self.assertEqual(listening, [f"0100007F:{self.port:04X}"])
        six = pathlib.Path("/proc/net/tcp6")
        self.assertFalse(six.exists() and any(
            line.split()[1].endswith(f":{self.port:04X}") and line.split()[3] == "0A"
            for line in six.read_text().splitlines()[1:]))

    def test_it_ends_where_nobody_would_know_its_address(self):
        for where, why in ((">/dev/full", "No space left on device"), (">&-", "Bad file descriptor")):
            view = subprocess.run(["sh", "-c", f'exec "$0" view a.nc {where}', G31], cwd=self.folder,
                                  stderr=subprocess.PIPE, text=True, timeout=GENEROUS)
            self.assertEqual(view.returncode, 2, view.stderr)
            self.assertEqual(view.stderr, f"g31: error: cannot write standard output: {why}\n")

    def test_a_port_that_is_taken_is_said(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            run = subprocess.run([G31, "view", "a.nc", "--port", str(port)], cwd=self.folder, capture_output=True,
                                 text=True, timeout=GENEROUS)
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        self.assertIn(f"--port {port}", run.stderr)

    def test_what_no_save_mends_is_refused_before_it_serves(self):
        for words, code, says in ((("--expect", "junk"), 2, "--expect junk: write NAME=VALUE+-TOLERANCE"), (("--set", "junk"), 2, "--set junk"),
                                  (("--expect", "#1=1", "--expect", "#1=2"), 2, "too: keep one of them"), (("--control", "nothing"), 5, "nothing")):
            view = subprocess.run([G31, "view", "a.nc", *words], cwd=self.folder, capture_output=True, text=True, timeout=GENEROUS)
            self.assertEqual((view.returncode, view.stdout), (code, ""), view.stderr)
            self.assertIn(says, view.stderr)

    def test_connections_that_say_nothing_keep_nobody_waiting(self):
        self.start()
        self.until("Completed")
        began = time.monotonic()
        silent = [socket.create_connection(("127.0.0.1", self.port)) for _ in range(300)]
        self.addCleanup(lambda: [one.close() for one in silent])
        self.assertLess(time.monotonic() - began, 10.0, "one that is not let wait comes again after 1 s")
        began = time.monotonic()
        self.assertEqual(self.ask()[0], 200)
        took = time.monotonic() - began
        print(f"answered {took:.2f} s behind 300 connections that say nothing", file=sys.stderr)
        self.assertLess(took, 2.0, "each of them is waited for 2 s")

    def test_clients_that_drip_take_nothing_or_say_nothing_do_not_delay_ctrl_c(self):
        self.start()
        self.until("Completed")
        links = [socket.create_connection(("127.0.0.1", self.port)) for _ in range(3)]
        self.addCleanup(lambda: [one.close() for one in links])
        drips, takes_nothing, _ = links
        takes_nothing.sendall(f"GET /?t={self.token} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n\r\n".encode())
        began = None
        for byte in b"GET / HTTP/1.1\r\nHost: " + b"x" * 1000:
            try:
                drips.send(bytes([byte]))
            except OSError:
                break
            time.sleep(0.05)
            if byte == ord("x") and began is None:
                began = time.monotonic()
                self.view.send_signal(signal.SIGINT)
            if self.view.poll() is not None:
                break
        self.assertEqual(self.view.wait(timeout=GENEROUS), 130)
        self.assertLess(time.monotonic() - began, 2.0)

    def test_a_request_that_drips_is_given_up(self):
        self.start()
        drips = socket.create_connection(("127.0.0.1", self.port))
        self.addCleanup(drips.close)
        began = time.monotonic()
        with self.assertRaises(OSError):
            while time.monotonic() - began < GENEROUS:
                drips.send(b"x")
                time.sleep(0.1)
        self.assertEqual(self.ask()[0], 200)


class Live(Served):
    def test_a_save_shows_and_so_does_an_error_until_it_is_mended(self):
        self.start("--expect", "#500=3")
        self.until("In tolerance")
        self.write("a.nc", PROGRAM.format(4))
        _, took = self.until("Out of tolerance")
        print(f"a new page {took:.2f} s behind the save", file=sys.stderr)
        self.write("a.nc", BROKEN)
        page, _ = self.until("Alarm 114", "a.nc")
        self.assertIn('<pre class="excerpt">    3 | #500=[1+\n', page)
        self.assertRegex(page, r"\n      \| +\^")
        new = self.folder / "new"
        new.write_text(PROGRAM.format(3))
        new.rename(self.folder / "a.nc")
        self.until("In tolerance")

    def test_an_input_that_never_rests_is_run_a_few_times_a_second(self):
        self.start()
        events = self.listen()
        first = self.heard(events)
        began = time.monotonic()
        number = 0
        while time.monotonic() - began < 4.0:
            number += 1
            self.write("a.nc", BROKEN + f"(LINE {number})\n")
            time.sleep(0.15)
        self.write("a.nc", PROGRAM.format(3))
        self.until("Completed")
        page = self.ask()[1]
        edition = int(re.search(r'data-edition="(\d+)"', page)[1])
        self.assertLessEqual(edition - first, 4 * 4, "four in two seconds, and those at both ends")

    def test_the_page_has_what_is_printed_and_every_stop(self):
        self.write("a.nc", "%\nO1\n#1=5\nPOPEN\nDPRNT[X#1[43]]\nPCLOS\n#3006=1(CLEAN THE PROBE)\nM0\nM30\n%\n")
        self.start()
        page, _ = self.until("Completed")
        begin = page.index("Printouts and messages")
        shown = page[begin:begin + 2000]
        self.assertNotIn("The program printed nothing", shown)
        self.assertRegex(shown, r"X +5\.000")
        self.assertIn("CLEAN THE PROBE", shown)
        run = subprocess.run([G31, "run", "a.nc", "--json", "-", "-q"], cwd=self.folder, capture_output=True, text=True)
        document = json.loads(re.search(r'id="g31-document">(.*?)</script>', page, re.S)[1])
        for list_ in ("output", "stops"):
            self.assertEqual(document[list_], json.loads(run.stdout)[list_])

    def test_two_windows_hear_of_each_edition(self):
        self.start()
        one, two = self.listen(), self.listen()
        first = self.heard(one)
        self.assertEqual(self.heard(two), first)
        self.assertIn(f'data-edition="{first}"', self.ask()[1])
        self.write("a.nc", PROGRAM.format(4))
        second = self.heard(one)
        self.assertGreater(second, first)
        self.assertEqual(self.heard(two), second)
        self.assertIn(f'data-edition="{second}"', self.ask()[1])

    def test_sheets_and_subprograms_count_and_those_that_are_missing(self):
        self.write("a.nc", "%\nO1\nM98 P2\nM30\n%\n")
        self.start("-s", "a.toml")
        self.until("a.toml", "data-edition")
        self.write("a.toml", '[variables]\n"#500" = "x"\n')
        self.until("a.toml", "SET104")
        self.write("a.toml", '[variables]\n"#500" = 2.0\n')
        self.until("Alarm")
        self.write("O2.nc", "%\nO2\n#501=#500*21\nM99\n%\n")
        page, _ = self.until("Completed", "O2.nc")
        self.assertIn("#501", page)

    def test_half_a_file_is_waited_for(self):
        self.start("--expect", "#500=3")
        events = self.listen()
        first = self.heard(events)
        whole = PROGRAM.format(4)
        with open(self.folder / "a.nc", "w") as file:
            for begin in range(0, len(whole), 8):
                file.write(whole[begin:begin + 8])
                file.flush()
                time.sleep(0.01)
        self.assertEqual(self.heard(events), first + 1)
        self.assertIn("Out of tolerance", self.ask()[1])

    def test_a_save_ends_a_run_that_goes_on(self):
        self.write("a.nc", "%\nO1\nWHILE[1EQ1]DO1\n#1=1\nEND1\nM30\n%\n")
        self.start("--max-time", "300", "--max-blocks", "999999999999")
        time.sleep(0.3)
        self.write("a.nc", PROGRAM.format(4))
        self.until("Completed")

    def test_who_looks_hears_that_a_newer_page_is_made(self):
        self.start("--max-time", "300", "--max-blocks", "999999999999")
        self.until("Completed")
        events = self.listen()
        first = self.heard(events)
        self.write("a.nc", "%\nO1\nWHILE[1EQ1]DO1\n#1=1\nEND1\nM30\n%\n")
        self.hears_of_work(events)
        self.write("a.nc", PROGRAM.format(4))
        self.assertGreater(self.heard(events), first)

    def test_nothing_is_written_and_ctrl_c_ends_it(self):
        self.write("a.toml", '[control]\nvariables_file = "kept.toml"\n')
        self.write("a.nc", "%\nO1\n#500=4\nPOPEN\nDPRNT[HELLO]\nPCLOS\nM30\n%\n")
        self.start("-s", "a.toml")
        events = self.listen()
        self.heard(events)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["a.nc", "a.toml"])
        self.view.send_signal(signal.SIGINT)
        out, err = self.view.communicate(timeout=GENEROUS)
        self.assertEqual((self.view.returncode, out), (130, ""), err)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["a.nc", "a.toml"])


    def test_a_document_has_its_address(self):
        self.start("--json", "where.json")
        written = json.loads((self.folder / "where.json").read_text())
        self.assertEqual(written, {"schema": "g31.view/1", "address": self.line.strip()})
        alone = subprocess.Popen([G31, "view", "a.nc", "--json", "-"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.addCleanup(alone.stdout.close)
        self.addCleanup(alone.wait)
        self.addCleanup(alone.kill)
        written = json.loads("".join(alone.stdout.readline() for _ in range(4)))
        self.assertRegex(written["address"], r"^http://127\.0\.0\.1:\d+/\?t=[0-9a-f]{32}$")

    def test_its_document_takes_no_place_of_what_it_reads(self):
        before = (self.folder / "a.nc").read_text()
        view = subprocess.run([G31, "view", "a.nc", "--json", "a.nc"], cwd=self.folder, capture_output=True, text=True,
                              timeout=GENEROUS)
        self.assertEqual((view.returncode, view.stdout), (2, ""), view.stderr)
        self.assertEqual((self.folder / "a.nc").read_text(), before)


class Refused(Served):
    def test_a_run_that_is_refused_writes_its_report(self):
        self.write("a.toml", '[probe]\nball_diameter = "wide"\n')
        for words, code, texts in ((("a.nc", "-s", "a.toml"), 2, ("Not run", "a.toml", "ball_diameter = &quot;wide&quot;")),
                                   (("none.nc",), 2, ("none.nc", "Not run")),
                                   (("a.nc", "--expect", "nonsense"), 2, ("Not run", "nonsense"))):
            run = subprocess.run([G31, "run", *words, "--report", "a.html"], cwd=self.folder, capture_output=True,
                                 text=True)
            self.assertEqual(run.returncode, code, run.stderr)
            page = (self.folder / "a.html").read_text()
            for text in texts:
                self.assertIn(text, page)
            self.assertNotIn("data-edition", page)
            self.assertNotIn("connect-src", page)
            (self.folder / "a.html").unlink()


if __name__ == "__main__":
    G31 = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
