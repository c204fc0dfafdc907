#!/usr/bin/env python3
"""The pages of docs and the README, followed to the letter: each command of a transcript says what the page shows.

Usage: manual_transcripts_test.py G31 [--update]

A transcript is a fenced block ```console: lines that begin with `$ ` are commands, what stands below each is what it
prints, standard error included.  A fenced block ```{.toml title="setup.toml"} is a file that is written where the page
shows it.  A page has a folder of its own, and its blocks come one after the other.  /usr/share/g31, where an
installed g31 keeps what comes with it, is this repository.  A picture that the page shows and its commands write is the
one that is shown.

--update writes what the commands print into the pages, and the pictures beside them: read `git diff` before it counts.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import kept_documents

ROOT = pathlib.Path(__file__).resolve().parents[2]
INSTALLED = "/usr/share/g31/"
FENCE = re.compile(r"```(.*)")
FILE = re.compile(r"""\{\.[\w-]+ title="([\w./-]+)"\}""")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)#:]+)\)")
README_TREE = ("macros", "machine", "parts", "docs")


def blocks_of(lines):
    """(what stands behind ```, number of the first line within, number of the closing line) of each block."""
    begin, info = None, ""
    for number, line in enumerate(lines):
        match = FENCE.fullmatch(line)
        if match and begin is None:
            begin, info = number + 1, match[1].strip()
        elif match and not match[1]:
            yield info, begin, number
            begin = None
    if begin is not None:
        raise AssertionError(f"line {begin}: the block does not end")


def pages():
    """Every page that has a transcript."""
    files = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [file for file in files if "\n```console\n" in file.read_text(encoding="utf-8")]


class Shell:
    """Runs the commands of one page, one after the other: folder and exit code go from one to the next."""

    def __init__(self, folder):
        self.root = self.folder = folder / "page"
        self.root.mkdir()
        programs = folder / "bin"
        programs.mkdir()
        (programs / "g31").symlink_to(G31)
        self.environment = {"PATH": f"{programs}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8", "TERM": "dumb",
                            "HOME": str(folder)}
        self.where = folder / "where"
        self.exit_code = 0

    def build_the_tree(self):
        """What the README names: it is read in the repository, after the build."""
        for name in README_TREE:
            (self.root / name).symlink_to(ROOT / name)
        (self.root / "build/release/tools/cli").mkdir(parents=True)
        (self.root / "build/release/tools/cli/g31").symlink_to(G31)

    def run(self, command):
        """What the command prints, line by line."""
        script = f"(exit {self.exit_code})\n{command.replace(INSTALLED, f'{ROOT}/')}\n" \
                 f"code=$?; pwd >'{self.where}'; exit $code"
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=300, check=False)
        self.exit_code = done.returncode
        self.folder = pathlib.Path(self.where.read_text(encoding="utf-8").rstrip("\n"))
        return done.stdout.replace(f"{ROOT}/", INSTALLED).splitlines()

    def write(self, name, lines):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        text = "".join(f"{line}\n" for line in lines).replace(INSTALLED, f"{ROOT}/")
        file.write_text(text, encoding="utf-8")


def answered(shell, lines):
    """The lines of a transcript as they should be: each command with what it prints now."""
    shown = []
    number = 0
    while number < len(lines):
        if not lines[number].startswith("$ "):
            number += 1
            continue
        command = [lines[number][2:]]
        shown.append(lines[number])
        while command[-1].endswith("\\"):
            number += 1
            command.append(lines[number])
            shown.append(lines[number])
        shown += shell.run("\n".join(command))
        number += 1
    return shown


def followed(page, folder):
    """The page as it should be, and the folder that its commands have filled."""
    lines = page.read_text(encoding="utf-8").split("\n")
    shell = Shell(folder)
    if page.name == "README.md" and page.parent == ROOT:
        shell.build_the_tree()
    result, copied = [], 0
    for info, begin, end in blocks_of(lines):
        file = FILE.fullmatch(info)
        if file:
            shell.write(file[1], lines[begin:end])
        elif info == "console":
            result += lines[copied:begin] + answered(shell, lines[begin:end])
            copied = end
    # What a page shows of standard output may be cut off.
    kept_documents.keep_folder(shell.root)
    return "\n".join(result + lines[copied:]), shell.root


def made_pictures(page, root):
    """(committed file, file made by the commands) of each picture of the page that its commands write."""
    for name in PICTURE.findall(page.read_text(encoding="utf-8")):
        made = list(root.rglob(pathlib.Path(name).name))
        if made:
            yield page.parent / name, made[0]


class Transcripts(unittest.TestCase):
    maxDiff = None

    def test_each_command_prints_what_the_page_shows(self):
        for page in pages():
            with self.subTest(page=page.name), tempfile.TemporaryDirectory() as folder:
                text, root = followed(page, pathlib.Path(folder))
                self.assertEqual(page.read_text(encoding="utf-8"), text)
                for committed, made in made_pictures(page, root):
                    self.assertEqual(committed.read_bytes(), made.read_bytes(), committed.name)

    def test_the_pages_are_there(self):
        names = {page.relative_to(ROOT).as_posix() for page in pages()}
        self.assertLessEqual({"README.md", "docs/tutorials/fanuc-shop.md"}, names)

    def test_a_wrong_line_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("# A\n```{.text title=\"a/b.txt\"}\nword\n```\n```console\n$ cat a/b.txt\nwrong\n"
                            "$ cd a\n$ pwd | grep -o a$; false\na\n$ echo $?\n```\n", encoding="utf-8")
            text, _ = followed(page, pathlib.Path(folder))
            self.assertEqual(text, page.read_text(encoding="utf-8").replace("wrong", "word").replace("$?\n", "$?\n1\n"))

    def test_a_block_without_an_end_is_seen(self):
        with self.assertRaises(AssertionError):
            list(blocks_of(["```console", "$ g31"]))


def update():
    for page in pages():
        with tempfile.TemporaryDirectory() as folder:
            text, root = followed(page, pathlib.Path(folder))
            page.write_text(text, encoding="utf-8")
            for committed, made in made_pictures(page, root):
                shutil.copyfile(made, committed)


if __name__ == "__main__":
    G31 = pathlib.Path(sys.argv[1]).resolve()
    if sys.argv[2:] == ["--update"]:
        update()
    else:
        unittest.main(argv=sys.argv[:1])
