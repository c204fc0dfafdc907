#!/usr/bin/env python3
"""Cuts the power at every system call of a run that saves its variables, and looks at what the disk has then.

    sudo tools/dev/cut_power.py build/release/tools/cli/g31

The variables are on a disk of their own, an image with ext4 that is written to only when it must be.  A run is
killed at each of its calls in turn; the image, as it is then, is what a disk has after a power loss: it is mounted
with its journal, and its variables file is that of before or that of after, byte for byte.  Behind a run that has
ended it is that of after.  Without fsync it is not, which is tried first.

Needs root, strace and mkfs.ext4 (Debian: strace, e2fsprogs).  Exit code 1 where something was lost.
"""
import collections
import pathlib
import shutil
import subprocess
import sys
import tempfile

DISKS = ["commit=600", "commit=600,data=writeback,noauto_da_alloc"]
CALLS = ["openat", "write", "fsync", "rename", "fchmod", "fchown", "close", "flock", "unlink", "getdents64",
         "newfstatat"]
DISK_BYTES = 64 << 20
VARIABLES = range(501, 1000)


def command(*words):
    subprocess.run(list(map(str, words)), check=True, stdout=subprocess.DEVNULL)


class Mounted:
    def __init__(self, image, place, options):
        self.image, self.place, self.options = image, place, options

    def __enter__(self):
        self.place.mkdir(exist_ok=True)
        command("mount", "-o", f"loop,{self.options}", self.image, self.place)

    def __exit__(self, *_):
        command("umount", self.place)


class Bench:
    """A disk before a run, and what became of it."""

    def __init__(self, g31, folder, options):
        self.folder, self.options = folder, options
        self.before, self.disk = folder / "before.img", folder / "disk.img"
        self.place = folder / "disk"
        (folder / "count.nc").write_text("%\nO1\n#500=#500+1\nM30\n%\n")
        (folder / "sheet.toml").write_text(
            f'[control]\nprofile = "fanuc-0i"\nvariables_file = "{self.place}/v.vars"\n')
        self.run = [g31, "run", folder / "count.nc", "--setup", folder / "sheet.toml"]
        with open(self.before, "wb") as image:
            image.truncate(DISK_BYTES)
        command("mkfs.ext4", "-q", "-F", self.before)
        settings = [word for i in VARIABLES for word in ("--set", f"#{i}={i}.125")]
        with Mounted(self.before, self.place, options):
            command(*self.run, *settings)
            self.old = (self.place / "v.vars").read_bytes()
        shutil.copy(self.before, self.disk)
        with Mounted(self.disk, self.place, options):
            command(*self.run)
            self.new = (self.place / "v.vars").read_bytes()

    def cut(self, call, which):
        """Kills a run at a call.
        @return whether it came to it, and what the disk has"""
        return self.with_calls(call, f"{call}:signal=SIGKILL:when={which}")

    def with_calls(self, call, injected):
        shutil.copy(self.before, self.disk)
        with Mounted(self.disk, self.place, self.options):
            ended = subprocess.run(["strace", "-f", "-o", "/dev/null", "-e", f"trace={call}", "-e",
                                    f"inject={injected}", *map(str, self.run)], capture_output=True, check=False)
            shutil.copy(self.disk, self.folder / "after.img")
        after = self.folder / "after"
        with Mounted(self.folder / "after.img", after, self.options):
            file = after / "v.vars"
            found = file.read_bytes() if file.exists() else b""
        kind = "old" if found == self.old else "new" if found == self.new else "lost"
        return ended.returncode != 0, kind


def try_disk(g31, folder, options):
    bench = Bench(g31, folder, options)
    _, kind = bench.with_calls("fsync", "fsync:retval=0")
    if kind == "new":
        sys.exit("a disk that keeps all without fsync shows nothing")
    counts, wrong = collections.Counter(), 0
    for call in CALLS:
        was_cut, which = True, 0
        while was_cut:
            which += 1
            was_cut, kind = bench.cut(call, which)
            counts[call if was_cut else "(ended)", kind] += 1
            wrong += kind == "lost" or (not was_cut and kind != "new")
    print(f"ext4, {options}: {sum(counts.values())} runs, {wrong} wrong")
    for (call, kind), count in sorted(counts.items()):
        print(f"  {call:12} {kind:5} {count:4}")
    return wrong


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    wrong = 0
    for options in DISKS:
        with tempfile.TemporaryDirectory(prefix="g31_power_") as name:
            wrong += try_disk(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(name), options)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
