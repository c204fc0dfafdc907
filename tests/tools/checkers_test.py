#!/usr/bin/env python3
"""The checkers of the house on made-up trees: a check that passes a wrong tree is worthless."""
import importlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
DEV = ROOT / "tools" / "dev"
sys.path.insert(0, str(DEV))
layers = importlib.import_module("check_layers")


class CheckerTest(unittest.TestCase):
    """Runs one checker, CHECKER, on a tree of {path: text}."""

    CHECKER = ""

    def run_on(self, files, folder="tree"):
        with tempfile.TemporaryDirectory() as parent:
            root = pathlib.Path(parent) / folder
            for name, text in files.items():
                path = root / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            command = [sys.executable, "-B", str(DEV / self.CHECKER), str(root)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode, done.stdout + done.stderr

    def passes(self, files, folder="tree"):
        code, out = self.run_on(files, folder)
        self.assertEqual(code, 0, out)

    def finds(self, files, problem, folder="tree"):
        code, out = self.run_on(files, folder)
        self.assertEqual(code, 1, out)
        self.assertIn(problem, out)


class Includes(CheckerTest):
    CHECKER = "check_layers.py"

    def test_what_the_picture_allows_passes(self):
        allowed = [
            ("machine/sim/a.cc", "machine/port/b.h"),
            ("machine/sim/a.cc", "machine/errors/b.h"),
            ("probe/sensor/a.h", "probe/contact/b.h"),
            ("interpreter/dialects/fanuc/execute/a.cc", "interpreter/dialects/fanuc/state/b.h"),
            ("tools/setup/a.cc", "interpreter/runtime/b.h"),
            ("tools/session/a.cc", "interpreter/dialects/fanuc/b.h"),
            ("tests/probe/a_test.cc", "tests/support/b.h"),
            ("machine/base/a.h", "machine/base/b.h"),
        ]
        for file, include in allowed:
            with self.subTest(f"{file} includes {include}"):
                self.passes({file: f'#include "{include}"\n#include <vector>\n'})

    def test_what_it_forbids_is_found_with_its_line(self):
        forbidden = [
            ("machine/base", "machine/units/b.h"),
            ("machine/port", "machine/sim/b.h"),
            ("machine/sim", "probe/sensor/b.h"),
            ("parts/geometry", "parts/import/b.h"),
            ("parts/artefacts", "probe/contact/b.h"),
            ("probe/contact", "interpreter/source/b.h"),
            ("probe/sensor", "machine/sim/b.h"),
            ("probe/metrology", "parts/geometry/b.h"),
            ("interpreter/runtime", "machine/sim/b.h"),
            ("interpreter/runtime", "interpreter/dialects/fanuc/b.h"),
            ("interpreter/dialects/fanuc/run", "interpreter/dialects/sinumerik/run/b.h"),
            ("interpreter/dialects/sinumerik/run", "interpreter/dialects/fanuc/run/b.h"),
            ("interpreter/dialects/fanuc/code", "interpreter/dialects/fanuc/state/b.h"),
            ("interpreter/dialects/sinumerik/explain", "interpreter/dialects/sinumerik/code/b.h"),
            ("interpreter/dialects/fanuc/execute", "probe/sensor/b.h"),
            ("tools/setup", "interpreter/dialects/fanuc/b.h"),
            ("tools/setup", "tools/cli/b.h"),
            ("tools/session", "tools/cli/b.h"),
            ("tools/cli", "interpreter/dialects/fanuc/b.h"),
            ("tools/study", "interpreter/dialects/sinumerik/b.h"),
            ("tools/report", "tools/setup/b.h"),
            ("probe/contact", "tools/setup/b.h"),
            ("machine/sim", "tests/support/b.h"),
        ]
        for layer, include in forbidden:
            with self.subTest(f"{layer} includes {include}"):
                problem = f"{layer}/a.cc:2: error: {layer} may not include {include}"
                self.finds({f"{layer}/a.cc": f'\n#include "{include}"\n'}, problem)

    def test_angle_brackets_are_no_way_round(self):
        self.finds({"machine/base/a.h": "# include <probe/contact/b.h>\n"}, "may not include probe/contact/b.h")

    def test_an_include_from_the_own_folder_names_the_folder(self):
        self.finds({"machine/base/a.h": '#include "b.h"\n'}, "may not include b.h")

    def test_a_name_that_only_begins_like_an_allowed_folder_is_found(self):
        self.finds({"machine/sim/a.h": '#include "machine/portable/b.h"\n'}, "may not include")

    def test_a_folder_without_a_row_is_found(self):
        self.finds({"helpers/a.h": "\n"}, "helpers/a.h:1: error: lies in no row")

    def test_a_checkout_in_a_folder_named_build_is_checked_too(self):
        files = {"machine/base/a.h": '#include "probe/contact/b.h"\n'}
        self.finds(files, "may not include", folder="build/tree")

    def test_build_folders_of_the_checkout_are_not(self):
        self.passes({"machine/base/a.h": "\n", "build/dev/a.h": '#include "x.h"\n'})

    def test_an_empty_tree_does_not_pass(self):
        self.finds({"README.md": "\n"}, "nothing was checked")


class Names(CheckerTest):
    CHECKER = "check_names.py"

    def test_names_that_say_something_pass(self):
        self.passes({"machine/sim/skip_stop.cc": "\n", "probe/contact/sweep_2.h": "\n"})

    def test_names_that_say_nothing_are_found(self):
        for file in ("machine/sim/utils.cc", "tools/common/a.h", "probe/mesh_helpers.h"):
            with self.subTest(file):
                self.finds({file: "\n"}, "says nothing about what is in it")

    def test_another_spelling_is_found(self):
        for file in ("machine/sim/SkipStop.cc", "tools/skip-stop.py", "probe/_a.h"):
            with self.subTest(file):
                self.finds({file: "\n"}, "names are lower case, words joined by _")


@unittest.skipUnless(shutil.which("clang-format"), "clang-format is not here")
class Format(CheckerTest):
    CHECKER = "check_format.py"

    def test_a_file_as_clang_format_writes_it_passes(self):
        self.passes({"a.h": "int a();\n"})

    def test_another_layout_is_found_with_its_line(self):
        self.finds({"a.h": "int a();\nint  b();\n"}, "a.h:2: error: clang-format writes it otherwise")


class Links(CheckerTest):
    CHECKER = "check_layers.py"

    def test_links_along_the_arrows_pass(self):
        text = "g31_library(g31_contact SOURCES contact/a.cc\n  DEPENDS g31_geometry g31_base fmt::fmt)\n"
        self.passes({"probe/CMakeLists.txt": text})

    def test_links_against_them_are_found(self):
        cases = [
            ("probe", "g31_contact", "DEPENDS g31_source", "probe/contact"),
            ("probe", "g31_contact", "PRIVATE_DEPENDS g31_fanuc", "probe/contact"),
            ("machine", "g31_base", "DEPENDS g31_units", "machine/base"),
            ("interpreter", "g31_fanuc", "DEPENDS g31_machine_sim", "interpreter/dialects/fanuc/run"),
            ("parts", "g31_geometry", "DEPENDS g31_part_import", "parts/geometry"),
        ]
        for folder, target, depends, layer in cases:
            with self.subTest(f"{target} {depends}"):
                text = f"# g31_base\ng31_library({target}\n  {depends})\n"
                problem = f"{folder}/CMakeLists.txt:2: error: {target} ({layer}) may not link"
                self.finds({f"{folder}/CMakeLists.txt": text}, problem)

    def test_a_plain_link_command_is_checked_too(self):
        text = "target_link_libraries(g31_contact PRIVATE g31_fanuc)\n"
        self.finds({"probe/CMakeLists.txt": text}, "may not link g31_fanuc")

    def test_a_source_from_another_folder_is_found(self):
        text = "g31_library(g31_contact SOURCES sensor/a.cc)\n"
        self.finds({"probe/CMakeLists.txt": text}, "g31_contact is probe/contact, probe/sensor/a.cc is not")

    def test_a_library_that_the_table_does_not_know_is_found(self):
        self.finds({"probe/CMakeLists.txt": "g31_library(g31_new SOURCES contact/a.cc)\n"}, "g31_new lies in no row")

    def test_a_comment_is_no_link(self):
        self.passes({"probe/CMakeLists.txt": "# g31_library(g31_contact DEPENDS g31_fanuc)\n"})


class Table(unittest.TestCase):
    def test_nobody_knows_himself_in_a_circle(self):
        knows = {
            row: {other for other in layers.MAY_INCLUDE if other != row and layers.may_know(row, other)}
            for row in layers.MAY_INCLUDE
        }
        while free := [row for row, others in knows.items() if not others & knows.keys()]:
            for row in free:
                del knows[row]
        self.assertEqual(knows, {})

    def test_architecture_shows_the_same_libraries(self):
        text = (ROOT / "ARCHITECTURE.md").read_text()
        shown = {
            target: folder
            for folder, targets in re.findall(r"^\| ([\w/]+) \| ([\w, ]+) \|", text, re.MULTILINE)
            for target in targets.split(", ")
            if target.startswith("g31_")
        }
        self.assertEqual(shown, layers.HOME)


class Tables(CheckerTest):
    CHECKER = "check_tables.py"

    def test_switches_and_comparisons_that_the_compiler_can_check_pass(self):
        lines = (
            "switch (static_cast<FunctionId>(op.detail)) {",
            "case FunctionId::SIN: return sine(a);",
            "case A::B: case A::C:",
            "case '(': f(a);",
            "case 7: f(static_cast<int>(A::B));",
            "// case static_cast<int>(A::B): a < A::B",
            'text = "a < A::B";',
            "return code == A::B || code != A::C;",
            "return i < Clocks::kTimers && i >= Place::first();",
            "std::map<A::B, int> a; b = c < 1'000 && d > e;",
            "if (a < Limits{}.most && b > Frame::Matrix(c)) {",
        )
        for line in lines:
            with self.subTest(line):
                self.passes({"a.cc": line + "\n"})

    def test_casts_in_case_labels_are_found(self):
        for line in ("case static_cast<int>(A::B):", "case static_cast<std::uint8_t>(n::A::B): f();", "case at(A::B):"):
            with self.subTest(line):
                self.finds({"a.cc": "\n" + line + "\n"}, "a.cc:2: error: a case label names its enumerator")

    def test_rows_that_nothing_names_are_found(self):
        table = 'ALARM(Raised, 1, "a")\nALARM(Forgotten, 2, "b")\n'
        for name, text in (("alarms.def", table), ("addresses.def", table.replace("ALARM", "ADDRESS"))):
            kind = "AlarmId" if name == "alarms.def" else "Address"
            with self.subTest(name):
                files = {f"d/vocabulary/{name}": text, "d/run/a.cc": f"f({kind}::Raised);  // {kind}::Forgotten\n"}
                self.finds(files, f"d/vocabulary/{name}:2: error: nothing names {kind}::Forgotten")
                self.passes(files | {"d/run/b.cc": f"f({kind}::Forgotten);\n"})
                self.passes(files | {f"d/vocabulary/{name}": text.replace('"b"', '"b: not simulated"')})

    def test_codes_of_two_messages_are_found(self):
        once = 'DIAGNOSTIC(A, "PRB1", Note, "a", "")\nRULE(B, "NC1", Note, "b", "")\n'
        files = {"a.cc": "int a;\n", "a.def": once}
        self.passes(files | {"b.def": 'SETUP_ERROR(A, "SET1", "a")\n'})
        self.finds(files | {"b.def": 'DIAGNOSTIC(C, "PRB1", Note, "c", "")\n'}, "b.def:1: error: PRB1 is the code of A")

    def test_switches_over_numbers_are_found(self):
        for kind in ("int", "unsigned", "std::size_t", "std::uint8_t"):
            with self.subTest(kind):
                self.finds({"a.h": f"switch (static_cast<{kind}>(id)) {{\n"}, "a.h:1: error: a switch over numbers")

    def test_the_order_of_enumerators_is_found(self):
        for line in ("a = id >= A::B;", "if (a < n::Id::BOUND) {", "return Id::First <= id;", "x = c <= A::B && d;"):
            with self.subTest(line):
                self.finds({"a.cc": f"/* 1\n2 */ {line}\n"}, "a.cc:2: error: enumerators have no order")


class Sizes(CheckerTest):
    CHECKER = "check_sizes.py"

    def test_a_file_at_the_limit_passes_and_one_line_more_is_found(self):
        for name in ("a.h", "a.cc", "a.py"):
            with self.subTest(name):
                self.passes({name: "\n" * 600})
                self.finds({name: "\n" * 601}, f"{name}:1: error: 601 lines")

    # Each with BODY for the lines between the braces; the signature begins in the first line.
    FUNCTIONS = {
        "a plain function": "int f() {\nBODY}\n",
        "a member": "A& A::operator=(const A& a) {\nBODY}\n",
        "a signature of two lines": "int f(int a,\n      int b) {\nBODY}\n",
        "a default argument in braces": "int f(A a = {}, B b = {1, 2}) {\nBODY}\n",
        "a trailing return type": "auto f() const noexcept(true) -> int {\nBODY}\n",
        "a template with a default": "template <typename T = int>\nT f() {\nBODY}\n",
        "a constructor with a braced member": "A::A() : a_{1}, b_(2) {\nBODY}\n",
        "a test": "TEST(Suite, Case) {\nBODY}\n",
        "a lambda as a value": "const auto f = [](int a) {\nBODY};\n",
        "a lambda called at once": "constexpr auto f = [] {\nBODY}();\n",
    }

    def test_functions_at_the_limit_pass_and_longer_ones_are_found(self):
        for name, text in self.FUNCTIONS.items():
            with self.subTest(name):
                around = text.count("\n")
                at_limit = text.replace("BODY", "  g();\n" * (60 - around))
                self.passes({"a.cc": at_limit})
                over = text.replace("BODY", "  g();\n" * (61 - around))
                self.finds({"a.cc": over}, "a.cc:1: error: a function of 61 lines")

    def test_a_long_function_is_found_wherever_it_stands(self):
        function = "int f() {\n" + "  g();\n" * 60 + "}\n"
        places = {
            "a namespace": ("namespace n::m {\n", "}\n"),
            "a class behind a label": ("class A final : public B {\n public:\n", "};\n"),
            "behind a table": ("constexpr int kA[] = {\n  f(1), {2},\n};\n", ""),
            "behind a call": ("static const A kA = make({1, 2});\n", ""),
            "behind braces in text": ("const char* a = \"{(\"; // {\nchar c = '{'; /* ( */ auto r = R\"({()\";\n", ""),
            "behind a macro": ("#define A(x) { \\\n  (\nint b;\n", ""),
            "behind a number with marks": ("int a = 1'000'000;\nchar c = '}';\n", ""),
        }
        for name, (before, after) in places.items():
            with self.subTest(name):
                line = before.count("\n") + 1
                self.finds({"a.cc": before + function + after}, f"a.cc:{line}: error: a function of 62 lines")

    def test_long_things_that_are_no_functions_pass(self):
        things = {
            "a table": "constexpr Case kCases[] = {\n" + "    {f(1), 2},\n" * 100 + "};\n",
            "a class": "class A {\n" + "  int f() { return 1; }\n" * 100 + "};\n",
            "an enum": "enum class A {\n" + "  B,\n" * 100 + "};\n",
            "two functions": ("int f() {\n" + "  g();\n" * 50 + "}\n") * 2,
        }
        for name, text in things.items():
            with self.subTest(name):
                self.passes({"a.cc": text})

    def test_a_long_python_function_is_found(self):
        self.passes({"a.py": "def f():\n" + "    g()\n" * 59})
        self.finds({"a.py": "def f():\n" + "    g()\n" * 60}, "a.py:1: error: a function of 61 lines")


class Paths(CheckerTest):
    CHECKER = "check_paths.py"

    def test_a_place_on_one_computer_is_found(self):
        # Put together here, or this file would be found itself.
        for place in ("ho" + "me/me/a.nc", "wo" + "rk/a", "tm" + "p/x.toml", "ro" + "ot/.cache"):
            for around in ("read('/{}')", "path = /{}", "/{}", "PATH=a:/{}", 'g31 --lib="/{}"'):
                text = around.format(place)
                with self.subTest(text):
                    self.finds({"a.md": f"\n{text}\n"}, "a.md:2: error: a path of one computer")

    def test_other_paths_pass(self):
        text = "#!/usr/bin/env bash\n../{0}/a\n$HOME/{0}/a\nhttps://a.org/{0}/b\n~/{0}/a\n$(pwd)/{0}/a\nbuild/{0}/a\n/proc/self/exe\n"
        self.passes({"a.sh": text.format("ho" + "me")})


if __name__ == "__main__":
    unittest.main()
