#!/usr/bin/env python3
"""The tree that `cmake --install` makes: it can be moved, and brings what programs, shells and man look for.

Usage: install_test.py BUILD_FOLDER VERSION
"""
import contextlib
import datetime
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

import kept_documents

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PLACES = (
    "bin/g31", "share/g31/macros/fanuc/O6001.nc", "share/g31/machine/library/v55.toml",
    "share/g31/parts/library/ring_gauge/ring.toml", "share/man/man1/g31.1", "share/man/man1/g31-run.1",
    "share/bash-completion/completions/g31", "share/zsh/vendor-completions/_g31",
    "share/fish/vendor_completions.d/g31.fish",
)
COMPLETE = """source "$1"
COMP_WORDS=("${@:2}")
COMP_CWORD=$(($# - 2))
_g31
printf '%s\\n' "${COMPREPLY[@]}"
"""
SHEET = """[probe]
ball_diameter = 6.0
length = 100.0
[start]
X = 60.0
Y = 0.0
Z = 100.0
[[part]]
name = "bolt"
file = "{file}"
at = [0.0, 0.0, 0.0]
"""


class InstalledTree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        first = pathlib.Path(cls.folder.name) / "first"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", first], check=True, capture_output=True)
        cls.root = pathlib.Path(cls.folder.name) / "moved"
        first.rename(cls.root)
        cls.about = json.loads(cls.g31("--version", "--json").stdout)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def g31(cls, *words):
        return kept_documents.run([cls.root / "bin/g31", *words], cls.root, capture_output=True, text=True)

    def options_of(self, command):
        words = self.g31(command, "--help").stdout.split("Examples")[0]
        return set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", words, re.MULTILINE))

    def test_files_lie_where_they_are_looked_for(self):
        for place in PLACES:
            self.assertTrue((self.root / place).is_file(), place)

    def test_the_version_is_the_project_s(self):
        self.assertEqual((self.about["schema"], self.about["version"]), ("g31.version/1", VERSION))
        self.assertEqual(self.g31("--version").stdout, f"g31 {VERSION}\n")

    def test_the_demo_of_the_readme_prints_what_it_says(self):
        ring = "share/g31/parts/library/ring_gauge"
        run = self.g31("run", "share/g31/macros/fanuc/O6001.nc", "--setup", f"{ring}/ring.toml",
                       "--setup", f"{ring}/late_probe.toml", "--print", "#517,#518")
        readme = (SOURCE / "README.md").read_text()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(len(run.stdout.splitlines()), 2)
        for line in run.stdout.splitlines():
            self.assertIn(f"\n{line}\n", readme)

    def test_the_report_s_script_and_style_come_along(self):
        if not (pathlib.Path(BUILD) / "share/g31/page/page.js").exists():
            self.skipTest("built without node and npm")
        ring = "share/g31/parts/library/ring_gauge"
        run = self.g31("run", f"{ring}/measure_ring.nc", "-s", f"{ring}/ring.toml", "--report", "ring.html")
        self.assertEqual(run.returncode, 0, run.stderr)
        html = (self.root / "ring.html").read_text(encoding="utf-8")
        for name in ("page.js", "page.css"):
            text = (self.root / "share/g31/page" / name).read_text(encoding="utf-8")
            self.assertGreater(len(text), 5_000)
            self.assertIn(text, html)

    def test_the_archive_carries_all_of_it(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cpack", "-G", "TGZ", "--config", f"{BUILD}/CPackConfig.cmake", "-B", folder], check=True,
                           capture_output=True)
            archive, = pathlib.Path(folder).glob("*.tar.gz")
            with tarfile.open(archive) as files:
                held = {name.split("/", maxsplit=1)[-1] for name in files.getnames()}
        installed = {str(file.relative_to(self.root)) for file in self.root.rglob("*") if file.is_file()}
        of_runs = {name for name in installed if "/" not in name}  # what tests have left
        self.assertEqual(sorted(installed - of_runs - held), [])

    def test_the_cycles_are_found(self):
        self.assertIn("CYCLE977", self.g31("explain", "CYCLE977", "--control", "sinumerik-828d").stdout)

    def module(self, name):
        """Of a part of the program that is loaded when it is needed."""
        return self.root / f"lib/g31/modules/{name}.so"

    @contextlib.contextmanager
    def without(self, module):
        hidden = module.with_suffix(".hidden")
        module.rename(hidden)
        try:
            yield
        finally:
            hidden.rename(module)

    def touch_and_miss_the_module(self, part, module, what_helps):
        """A part of half width 10 about the origin, and a ball of radius 3."""
        (self.root / "skip.nc").write_text("%\nO1\nG91 G31 X-60. F100\nM30\n%\n")
        (self.root / "part.toml").write_text(SHEET.format(file=part))
        call = ("run", "skip.nc", "--control", "fanuc-30i", "-s", "part.toml", "--print", "#5061")
        run = self.g31(*call)
        self.assertEqual(run.stdout, "#5061 = 13\n", run.stderr)
        with self.without(self.module(module)):
            run = self.g31(*call)
        self.assertEqual(run.returncode, 5)
        self.assertIn(what_helps, run.stderr)
        self.assertIn("part.toml:10:8", run.stderr)

    def test_a_step_part_is_touched_and_without_the_module_its_remedy_is_named(self):
        if not self.module("g31_step").exists():
            self.skipTest("built without Open CASCADE")
        self.touch_and_miss_the_module(SOURCE / "tests/parts/cylinder.step", "g31_step", "install g31 again, where it was")

    def test_an_obj_part_is_touched_and_without_the_module_its_remedy_is_named(self):
        part = self.root / "cube.obj"
        corners = [(x, y, z) for x in (-10, 10) for y in (-10, 10) for z in (-20, 0)]
        faces = ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
        part.write_text("".join("v {} {} {}\n".format(*corner) for corner in corners)
                        + "".join(f"f {face}\n" for face in faces))
        self.touch_and_miss_the_module(part, "g31_assimp", "install g31 again, or save the part as STL")

    def test_without_its_module_a_page_is_not_served_and_its_remedy_is_named(self):
        (self.root / "ends.nc").write_text("%\nO1\nM30\n%\n")
        with self.without(self.module("g31_server")):
            view = self.g31("view", "ends.nc", "--control", "fanuc-30i")
        self.assertEqual(view.returncode, 2)
        self.assertIn("install g31 again", view.stderr)

    def test_only_what_needs_a_library_waits_for_it(self):
        for tool, held in (("bin/g31", ""), ("lib/g31/modules/g31_assimp.so", "assimp"),
                           ("lib/g31/modules/g31_server.so", "httplib")):
            needed = subprocess.run(["objdump", "-p", self.root / tool], capture_output=True, text=True, check=True)
            libraries = [line for line in needed.stdout.splitlines() if "NEEDED" in line]
            for library in ("assimp", "httplib", "crypto", "TKSTEP"):
                self.assertEqual(any(library in line for line in libraries), library == held, f"{tool}: {library}")

    def test_no_library_is_looked_for_in_the_folder_where_the_program_is_called(self):
        built = pathlib.Path(BUILD) / "tools"
        for root, program in ((built, "cli/g31"), (self.root, "bin/g31")):
            for binary in (root / program, *(root / "lib/g31/modules").glob("*.so")):
                wanted = subprocess.run(["objdump", "-p", binary], capture_output=True, text=True, check=True)
                paths = [words[1] for words in map(str.split, wanted.stdout.splitlines())
                         if words[:1] in (["RPATH"], ["RUNPATH"])]
                self.assertEqual(paths, ["$ORIGIN/../lib/g31/modules"] if binary == root / program else [])

    def complete(self, *words):
        script = self.root / "share/bash-completion/completions/g31"
        run = subprocess.run(["bash", "-c", COMPLETE, "bash", script, *words], cwd=self.root,
                             capture_output=True, text=True, check=True)
        return set(run.stdout.split())

    def test_bash_completes_commands_options_choices_and_files(self):
        self.assertEqual(self.complete("g31", ""), set(self.about["commands"]))
        self.assertEqual(self.complete("g31", "run", "--cont"), {"--control"})
        self.assertEqual(self.complete("g31", "run", "--control", ""), set(self.about["controls"]))
        self.assertEqual(self.complete("g31", "check", "--format", "j"), {"json"})
        # As bash gives words where = breaks them, behind the sign and within the value; and where it does not.
        self.assertEqual(self.complete("g31", "check", "--format", "="), {"text", "json", "sarif", "github"})
        self.assertEqual(self.complete("g31", "check", "--format", "=", "j"), {"json"})
        self.assertEqual(self.complete("g31", "check", "--format=j"), {"--format=json"})
        self.assertEqual(self.complete("g31", "manual", ""), set(self.about["commands"]))
        self.assertEqual(self.complete("g31", "evaluate", "c"), {"circle", "cylindricity"})
        self.assertEqual(self.complete("g31", "evaluate", "circle", "share/g31/macros/fanuc/O600"),
                         {f"share/g31/macros/fanuc/O600{n}.nc" for n in (1, 2, 3)})
        self.assertEqual(self.complete("g31", "evaluate", "--unit", "u"), {"um"})
        self.assertEqual(self.complete("g31", "evaluate", "--sense", ""), {"travel", "gap"})
        self.assertEqual(self.complete("g31", "evaluate", "--compensation-format", "s"), {"sheet", "sinumerik"})
        self.assertEqual(self.complete("g31", "run", "--lang", ""), {"en", "ja"})
        self.assertEqual(self.complete("g31", "run", "-s", "share/g31/machine/library/v"),
                         {"share/g31/machine/library/v55.toml"})
        self.assertEqual(self.complete("g31", "run", "share/g31/macros/fanuc/O600"),
                         {f"share/g31/macros/fanuc/O600{n}.nc" for n in (1, 2, 3)})

    def test_values_that_are_files_are_completed_as_files(self):
        zsh = (self.root / "share/zsh/vendor-completions/_g31").read_text()
        for option in ("--compare", "--printer", "--stock"):
            self.assertRegex(zsh, rf"'{option}\[.*:_files'", option)

    def test_each_option_of_each_command_is_completed_and_in_the_manual(self):
        scripts = [(self.root / place).read_text() for place in PLACES if "completion" in place]
        for command in self.about["commands"]:
            page = (self.root / f"share/man/man1/g31-{command}.1").read_text().replace("\\-", "-")
            self.assertIn(f"g31-{command} - ", page)
            options = self.options_of(command)
            self.assertIn("--help", options)
            for option in options:
                self.assertIn(option, page)
                for script in scripts:
                    self.assertRegex(script, rf"{option}\b|-l {option[2:]}\b")
            self.assertIn("EXIT STATUS", page)
            self.assertNotIn("Examples:", page)

    def test_the_pages_of_the_manual_have_no_fault_and_the_date_of_the_package(self):
        pages = sorted((self.root / "share/man/man1").glob("*.1"))
        self.assertEqual(len(pages), len(self.about["commands"]) + 1)
        changes = (SOURCE / "tools/cmake/debian_files.cmake").read_text()
        day = datetime.datetime.strptime(re.search(r"\w{3}, (\d+ \w{3} \d{4}) 00:00", changes)[1], "%d %b %Y")
        for page in pages:
            self.assertIn(f" 1 {day:%Y-%m-%d} ", page.read_text().splitlines()[0])
        if shutil.which("mandoc"):
            lint = subprocess.run(["mandoc", "-Tlint", *pages], capture_output=True, text=True)
            self.assertEqual(lint.stdout + lint.stderr, "")

    def test_zsh_and_fish_can_read_their_scripts(self):
        for shell, place in (("zsh", PLACES[-2]), ("fish", PLACES[-1])):
            if shutil.which(shell):
                subprocess.run([shell, "-n", self.root / place], check=True)


if __name__ == "__main__":
    BUILD, VERSION = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
