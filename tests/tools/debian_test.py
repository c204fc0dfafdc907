#!/usr/bin/env python3
"""tools/dev/debian.sh against made-up commands: apt is called for what is missing, and only then."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "dev" / "debian.sh"
NEEDED = ("bash", "cat", "env", "grep")


class Debian(unittest.TestCase):
    """Each test has a folder of commands that is the whole PATH; what they were asked is in `calls`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.calls = self.root / "calls"
        self.bin = self.root / "bin"
        self.bin.mkdir()
        for name in NEEDED:
            (self.bin / name).symlink_to(shutil.which(name))

    def command(self, name, body):
        path = self.bin / name
        path.write_text(f"#!{self.bin}/bash\n{body}\n")
        path.chmod(0o755)

    def machine(self, installed, user, sudo=False, apt="exit 0"):
        """A Debian with these packages: all, or all but some."""
        lines = f'for p in "$@"; do case " {installed} " in *" $p "*) ;; *) echo "$p installed";; esac; done; exit 1'
        self.command("dpkg-query", f"shift 3; {lines}")
        self.command("id", f"echo {user}")
        self.command("apt-get", f'echo "apt-get $*" >>{self.calls}; echo words of apt; {apt}')
        if sudo:
            self.command("sudo", f'echo sudo >>{self.calls}; exec "$@"')

    def install(self):
        done = subprocess.run(
            [str(self.bin / "bash"), "-euc", f"set -o pipefail; source '{SCRIPT}'; g31_install_packages '{self.root}/log'"],
            env={"PATH": str(self.bin)}, capture_output=True, text=True, check=False)
        calls = self.calls.read_text() if self.calls.exists() else ""
        return done.returncode, done.stdout, done.stderr, calls

    def test_nothing_is_called_when_nothing_is_missing(self):
        self.machine("", user=1000)
        self.assertEqual(self.install(), (0, "", "", ""))

    def test_root_installs_what_is_missing_and_nothing_else(self):
        self.machine("cmake libfcl-dev", user=0)
        code, out, err, calls = self.install()
        self.assertEqual((code, out, err), (0, "Installing: cmake libfcl-dev\n", ""))
        self.assertEqual(calls.splitlines()[0], "apt-get update")
        self.assertTrue(calls.splitlines()[1].endswith("--no-install-recommends cmake libfcl-dev"), calls)
        self.assertNotIn("sudo", calls)

    def test_a_user_installs_with_sudo(self):
        self.machine("cmake", user=1000, sudo=True)
        code, _, err, calls = self.install()
        self.assertEqual((code, err), (0, ""))
        self.assertEqual([line.split()[0] for line in calls.splitlines()], ["sudo", "apt-get"] * 2)

    def test_a_user_without_sudo_is_told_what_to_ask_for(self):
        self.machine("cmake g++", user=1000)
        code, _, err, calls = self.install()
        self.assertEqual((code, calls), (1, ""))
        self.assertIn("neither root nor sudo is at hand: g++ cmake", err)
        self.assertIn("apt-get install -y --no-install-recommends g++ cmake", err)

    def test_the_words_of_apt_are_shown_when_it_fails(self):
        self.machine("cmake", user=0, apt="exit 100")
        code, _, err, calls = self.install()
        self.assertEqual((code, calls), (1, "apt-get update\n"))
        self.assertIn("words of apt", err)
        self.assertIn("By hand, as root: apt-get update && apt-get install", err)

    def test_another_system_is_told_that_debian_is_meant(self):
        code, _, err, _ = self.install()
        self.assertEqual(code, 1)
        self.assertIn("Debian 12", err)


if __name__ == "__main__":
    unittest.main()
